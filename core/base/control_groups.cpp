// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/control_groups.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace proveout {

namespace {

namespace fs = std::filesystem;

/// The file names and keys of one version of control groups. Both versions write "max", or a number larger
/// than any memory, for no limit.
struct GroupFiles {
    std::array<const char*, 2> limits; ///< beyond the second, the group is slowed down to a standstill
    const char* usage;
    std::array<std::string_view, 2> cached; ///< keys of memory.stat
};
constexpr GroupFiles kVersion1{{"memory.limit_in_bytes", "memory.limit_in_bytes"},
                               "memory.usage_in_bytes",
                               {"total_inactive_file", "total_active_file"}};
constexpr GroupFiles kVersion2{
    {"memory.max", "memory.high"}, "memory.current", {"inactive_file", "active_file"}};

std::optional<std::uint64_t> numberIn(const fs::path& file) {
    std::uint64_t number = 0;
    if (std::ifstream(file) >> number)
        return number;
    return std::nullopt;
}

std::uint64_t cachedBytes(const fs::path& group, const GroupFiles& files) {
    std::ifstream lines(group / "memory.stat");
    std::string key;
    std::uint64_t bytes = 0;
    std::uint64_t cached = 0;
    while (lines >> key >> bytes)
        if (std::ranges::find(files.cached, key) != files.cached.end())
            cached += bytes;
    return cached;
}

void addGroup(const fs::path& group, const GroupFiles& files, GroupMemory& least) {
    std::optional<std::uint64_t> limit;
    for (const char* name : files.limits)
        if (const auto number = numberIn(group / name))
            limit = std::min(limit.value_or(*number), *number);
    if (!limit)
        return;
    least.limit = std::min(least.limit, *limit);
    const std::uint64_t usage = numberIn(group / files.usage).value_or(0);
    const std::uint64_t used = usage - std::min(usage, cachedBytes(group, files));
    least.available = std::min(least.available, *limit - std::min(*limit, used));
}

/// Adds the groups from the top group down to `path`, as /proc/self/cgroup names it. A path that leads out of
/// the top group names one that is not visible here.
void addGroups(const fs::path& top, std::string_view path, const GroupFiles& files, GroupMemory& least) {
    fs::path group = top;
    addGroup(group, files, least);
    for (const fs::path& name : fs::path(path).relative_path()) {
        if (name == "..")
            return;
        group /= name;
        addGroup(group, files, least);
    }
}

/// Whether the list "cpu,memory" has the entry.
bool lists(std::string_view list, std::string_view entry) {
    while (!list.empty()) {
        const std::size_t comma = std::min(list.find(','), list.size());
        if (list.substr(0, comma) == entry)
            return true;
        list.remove_prefix(std::min(comma + 1, list.size()));
    }
    return false;
}

} // namespace

GroupMemory controlGroupMemory(const MemorySources& sources) {
    GroupMemory least;
    // The topmost groups count also where the system does not say which groups are ours.
    addGroup(sources.controlGroups, kVersion2, least);
    addGroup(sources.controlGroups / "memory", kVersion1, least);
    std::ifstream groups(sources.proc / "self" / "cgroup");
    for (std::string line; std::getline(groups, line);) { // "4:memory:/path", "0::/path"
        const std::size_t first = line.find(':');
        const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
        if (second == std::string::npos)
            continue;
        const std::string_view controllers = std::string_view(line).substr(first + 1, second - first - 1);
        const std::string_view path = std::string_view(line).substr(second + 1);
        if (controllers.empty())
            addGroups(sources.controlGroups, path, kVersion2, least);
        else if (lists(controllers, "memory"))
            addGroups(sources.controlGroups / "memory", path, kVersion1, least);
    }
    return least;
}

} // namespace proveout
