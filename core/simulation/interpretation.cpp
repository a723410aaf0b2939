// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/interpretation.h"

#include <algorithm>
#include <map>
#include <utility>

namespace proveout {

ToolOffsets toolOffsets(const ToolTable& tools) {
    std::map<int, ToolOffset> offsets;
    for (const auto& [number, cutter] : tools.tools())
        offsets[number].diameter = 2 * cutter.radius();
    return ToolOffsets(std::move(offsets));
}

InterpretOptions interpretOptions(const Setup& setup, const std::filesystem::path& file) {
    InterpretOptions options;
    options.file = file.string();
    options.dialect = setup.dialect;
    options.blockDelete = setup.blockDelete;
    options.start = setup.start;
    options.tools = toolOffsets(setup.tools);
    if (!file.empty())
        options.subprogramFolders = {file.parent_path()};
    return options;
}

bool interpretedAlike(const Program& program, const Setup& one, const Setup& other) {
    const auto sameTool = [](const auto& a, const auto& b) {
        return a.first == b.first && a.second.radius() == b.second.radius();
    };
    return one.dialect == other.dialect && one.blockDelete == other.blockDelete && one.start == other.start &&
           (!program.asksForTools() || std::ranges::equal(one.tools.tools(), other.tools.tools(), sameTool));
}

} // namespace proveout
