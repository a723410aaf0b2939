// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/control_groups.h"

#include <limits>

#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

constexpr auto kNone = std::numeric_limits<std::uint64_t>::max();

/// File trees as Linux provides them.
class ControlGroups : public testing::Test {
protected:
    void put(const std::string& file, const std::string& text) const {
        std::filesystem::create_directories((folder / file).parent_path());
        folder.put(file, text);
    }
    void putOwnGroups(const std::string& lines) const { put("proc/self/cgroup", lines); }
    void putVersion2(const std::string& group, const std::string& most, std::uint64_t used) const {
        put("groups" + group + "/memory.max", most + "\n");
        put("groups" + group + "/memory.current", std::to_string(used) + "\n");
    }
    void putVersion1(const std::string& group, std::uint64_t most, std::uint64_t used) const {
        put("groups/memory" + group + "/memory.limit_in_bytes", std::to_string(most) + "\n");
        put("groups/memory" + group + "/memory.usage_in_bytes", std::to_string(used) + "\n");
    }
    [[nodiscard]] GroupMemory read() const { return controlGroupMemory(sources()); }
    [[nodiscard]] MemorySources sources() const { return {folder / "proc", folder / "groups"}; }

    TemporaryFolder folder;
};

TEST_F(ControlGroups, WithoutAnyNothingIsLimited) {
    EXPECT_EQ(read().limit, kNone);
    EXPECT_EQ(read().available, kNone);
    putOwnGroups("0::/user.slice/one.scope\n12:memory:/somewhere\nnonsense\n::\n");
    EXPECT_EQ(read().available, kNone);
}

TEST_F(ControlGroups, TheTopOneOfVersion2IsThatOfAContainer) {
    putOwnGroups("0::/\n");
    putVersion2("", "4000", 1500);
    EXPECT_EQ(read().limit, 4000U);
    EXPECT_EQ(read().available, 2500U);
}

TEST_F(ControlGroups, OfNestedOnesTheTightestCounts) {
    putOwnGroups("0::/user.slice/job.scope/part\n");
    putVersion2("/user.slice", "8000", 7100);
    putVersion2("/user.slice/job.scope", "5000", 1000);
    putVersion2("/user.slice/job.scope/part", "max", 900);
    putVersion2("/user.slice/other.scope", "10", 9); // another process
    EXPECT_EQ(read().limit, 5000U);
    EXPECT_EQ(read().available, 900U) << "of user.slice, for others of its groups use the rest";
}

TEST_F(ControlGroups, BeyondTheHighMarkAGroupOnlyCrawls) {
    putOwnGroups("0::/job\n");
    putVersion2("/job", "9000", 1000);
    put("groups/job/memory.high", "3000\n");
    EXPECT_EQ(read().limit, 3000U);
    EXPECT_EQ(read().available, 2000U);
}

TEST_F(ControlGroups, ThoseOfVersion1AreReadAsWell) {
    putOwnGroups("9:name=systemd:/\n4:cpu,memory:/docker/abc\n0::/\n");
    putVersion1("", 9223372036854771712U, 50'000'000'000U);
    putVersion1("/docker", 9223372036854771712U, 40'000'000'000U);
    putVersion1("/docker/abc", 6'000'000'000U, 2'000'000'000U);
    EXPECT_EQ(read().limit, 6'000'000'000U);
    EXPECT_EQ(read().available, 4'000'000'000U);
}

TEST_F(ControlGroups, WithinAContainerOfVersion1TheTopFolderIsTheOwnGroup) {
    putOwnGroups("4:memory:/docker/abc\n"); // the path as seen by the host
    putVersion1("", 6000, 2000);
    EXPECT_EQ(read().available, 4000U);
}

TEST_F(ControlGroups, FilesKeptForSpeedCountAsFree) {
    putOwnGroups("4:memory:/a\n0::/b\n");
    putVersion1("/a", 9000, 5000);
    put("groups/memory/a/memory.stat", "cache 1\ninactive_file 7\ntotal_inactive_file 1000\n"
                                       "total_active_file 500\n");
    EXPECT_EQ(read().available, 5500U);
    putVersion2("/b", "9000", 8000);
    put("groups/b/memory.stat", "anon 4000\nfile 3000\ninactive_file 2000\nactive_file 600\n");
    EXPECT_EQ(read().available, 3600U);
}

TEST_F(ControlGroups, MoreUsedThanAllowedLeavesNothing) {
    putOwnGroups("0::/b\n");
    putVersion2("/b", "3000", 8000);
    EXPECT_EQ(read().available, 0U);
    put("groups/b/memory.stat", "inactive_file 99999999\n"); // more than is in use
    EXPECT_EQ(read().available, 3000U);
}

TEST_F(ControlGroups, APathOutOfTheTopGroupIsNotFollowed) {
    putOwnGroups("0::/../../proc\n");
    putVersion2("", "max", 10);
    put("proc/memory.max", "1\n");
    EXPECT_EQ(read().available, kNone);
}

TEST_F(ControlGroups, LimitWhatAJobMayTake) {
    put("proc/meminfo", "MemTotal:       16000000 kB\nMemFree:  1 kB\nMemAvailable:   12000000 kB\n");
    EXPECT_EQ(availableMemoryBytes(sources()), 12'000'000ULL * 1024);
    EXPECT_EQ(memoryLimitBytes(sources()), 8'000'000ULL * 1024) << "half of the machine";
    putOwnGroups("0::/user.slice/job.scope\n");
    putVersion2("/user.slice/job.scope", "3000000000", 2'000'000'000);
    EXPECT_EQ(availableMemoryBytes(sources()), 1'000'000'000U);
    EXPECT_EQ(memoryLimitBytes(sources()), 1'000'000'000U);
    putVersion2("/user.slice/job.scope", "3000000000", 200'000'000);
    EXPECT_EQ(availableMemoryBytes(sources()), 2'800'000'000U);
    EXPECT_EQ(memoryLimitBytes(sources()), 1'500'000'000U) << "half of the group";
}

} // namespace
} // namespace proveout
