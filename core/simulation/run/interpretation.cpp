// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/interpretation.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>

#include "core/base/memory.h"
#include "core/nc/codes/dialects.h"
#include "core/simulation/run/probed_stock.h"
#include "core/simulation/setup/setup_fields.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

ToolOffsets toolOffsets(const ToolTable& tools) {
    std::map<int, ToolOffset> offsets;
    for (const auto& [number, cutter] : tools.tools()) {
        const ToolOrigin* origin = tools.unconfirmedOrigin(number);
        const bool assumed = origin != nullptr && !origin->states("d"); // the diameter, in specs
        offsets[number] = {Vec3(0), 2 * cutter.radius(), assumed};
    }
    return ToolOffsets(std::move(offsets));
}

std::uint64_t programBytesThatFit() {
    constexpr std::uint64_t kRounded = 64'000'000;
    const std::uint64_t fit = std::max<std::uint64_t>(memoryLimitBytes() / 2 / kRounded, 1) * kRounded;
    return std::min(fit, InterpretOptions().maxBytes);
}

void setControl(const Setup& setup, InterpretOptions& options) {
    options.dialect = setup.dialect;
    options.blockDelete = setup.blockDelete;
    options.compensationTypeB = setup.compensationTypeB;
    options.ignoredM = setup.ignoredM;
    options.start = setup.start;
    options.startTool = setup.startTool.value_or(0);
}

InterpretOptions interpretOptions(const Setup& setup, const std::filesystem::path& file) {
    InterpretOptions options;
    options.file = file.string();
    setControl(setup, options);
    options.tools = toolOffsets(setup.tools);
    options.maxBytes = programBytesThatFit();
    if (checkShape(setup.shape))
        options.part = partToProbe(setup);
    if (!file.empty())
        options.subprogramFolders = {file.parent_path()};
    return options;
}

InterpretOptions interpretOptions(const Setup& setup, const std::filesystem::path& file,
                                  const Program& program) {
    InterpretOptions options = interpretOptions(setup, file);
    if (!setup.startTool)
        options.startTool = toolToInterpretWith(program, setup.tools).value_or(0);
    return options;
}

std::optional<int> toolToInterpretWith(const Program& program, const ToolTable& tools) {
    return program.asksForTools() ? assumedTool(program, tools) : std::nullopt;
}

std::shared_ptr<const Program> withAssumedTool(std::shared_ptr<const Program> program,
                                               const InterpretOptions& options, const ToolTable& tools,
                                               const InterpretAgain& again) {
    const std::optional<int> tool = toolToInterpretWith(*program, tools);
    if (!tool || *tool == options.startTool)
        return program;
    InterpretOptions assuming = options;
    assuming.startTool = *tool;
    auto assumed = again(assuming);
    // Values that a program reads from its tool may change its flow.
    return toolToInterpretWith(*assumed, tools) == tool ? assumed : program;
}

std::shared_ptr<const Program> interpretOn(const Setup& setup, const NcText& text,
                                           const InterpretOptions& options) {
    auto program = interpret(text, options);
    if (setup.startTool)
        return program;
    return withAssumedTool(std::move(program), options, setup.tools,
                           [&](const InterpretOptions& assuming) { return interpret(text, assuming); });
}

bool interpretedAlike(const Program& program, const Setup& one, const Setup& other) {
    if (program.asksForStock() &&
        (one.stock != other.stock || one.shape != other.shape || one.tools != other.tools))
        return false;
    bool same = !program.asksForTools() || toolOffsets(one.tools) == toolOffsets(other.tools);
    eachControlField([&](auto place, const Field& field) {
        const bool used =
            &field != &setup_field::kCompensationStart || dialect(program.dialect()).vectors.used;
        same = same && (!used || std::invoke(place, one) == std::invoke(place, other));
    });
    return same;
}

} // namespace proveout
