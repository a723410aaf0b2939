// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/run_json.h"

#include <fmt/format.h>
#include <optional>

#include "core/simulation/setup/tool_choice.h"

namespace proveout::cli {

namespace {

nlohmann::ordered_json extreme(const RunTotals::Extreme& of, const Program& program) {
    if (of.value <= 0)
        return nullptr;
    return {{"mm", of.value}, {"block", of.block + 1}, {"line", program.blockLine(of.block)}};
}

nlohmann::ordered_json firstContact(const RunTotals& totals, const Program& program,
                                    const std::shared_ptr<const Setup>& setup) {
    if (!totals.firstContact)
        return nullptr;
    const std::size_t block = *totals.firstContact;
    nlohmann::ordered_json out{{"block", block + 1}, {"line", program.blockLine(block)}};
    if (const auto place = contactPlace(setup, program, block))
        out.update({{"x", place->x}, {"y", place->y}, {"z", place->z}});
    return out;
}

} // namespace

nlohmann::ordered_json startToolAsJson(const Program& program, const Setup& setup) {
    const std::optional<int> assumed = assumedTool(program, setup);
    if (!assumed && !setup.startTool)
        return nullptr;
    return {{"number", assumed ? *assumed : *setup.startTool}, {"assumed", assumed.has_value()}};
}

nlohmann::ordered_json ignoredCodesAsJson(const Program& program) {
    auto list = nlohmann::ordered_json::array();
    for (const auto& [number, code] : program.ignoredCodes()) {
        const bool known = *code.name != '\0';
        list.push_back({{"code", fmt::format("M{}", number)},
                        {"meaning", known ? nlohmann::ordered_json(code.name) : nullptr},
                        {"by", known ? "dialect" : "setup"},
                        {"count", code.count},
                        {"lines", code.lines}});
    }
    return list;
}

nlohmann::ordered_json totalsAsJson(const RunTotals& totals, const Program& program,
                                    const std::shared_ptr<const Setup>& setup) {
    return {{"cuttingLengthMm", totals.cuttingLength},
            {"airLengthMm", totals.airLength},
            {"rapidLengthMm", totals.rapidLength},
            {"cuttingBlocks", totals.cuttingBlocks},
            {"airBlocksAtFeed", totals.airBlocks},
            {"contacts", totals.contacts},
            {"axialDepth", extreme(totals.axialDepth, program)},
            {"radialEngagement", extreme(totals.radialEngagement, program)},
            {"firstContact", firstContact(totals, program, setup)}};
}

} // namespace proveout::cli
