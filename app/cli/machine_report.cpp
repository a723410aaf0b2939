// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/machine_report.h"

#include <cmath>
#include <fmt/format.h>

namespace proveout::cli {

namespace {

nlohmann::ordered_json toJson(const TimeParts& parts) {
    return {{"total", parts.total()},
            {"rapid", parts.rapid},
            {"feed", parts.feed},
            {"dwell", parts.dwell},
            {"toolChange", parts.toolChange}};
}

} // namespace

nlohmann::ordered_json machineSeconds(const MachineTimes& times, std::size_t blocks, bool assumed,
                                      const ToolChoice& tools) {
    nlohmann::ordered_json out = toJson(times.parts);
    out["executed"] = times.secondsAfter[blocks];
    out["tools"] = nlohmann::ordered_json::array();
    for (const MachineTimes::OfTool& tool : times.tools) {
        nlohmann::ordered_json row{{"tool", tools.tool(tool.tool)}, {"assumed", tools.isAssumed(tool.tool)}};
        row.update(toJson(tool.parts));
        row["feedLengthMm"] = tool.feedLength;
        out["tools"].push_back(std::move(row));
    }
    out["assumed"] = assumed;
    out["motionsWithoutFeed"] = times.motionsWithoutFeed;
    out["motionsFromUnknown"] = times.motionsFromUnknown;
    return out;
}

std::string clockText(double seconds) {
    const auto whole = static_cast<long long>(std::llround(seconds));
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

} // namespace proveout::cli
