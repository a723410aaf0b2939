// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/records_csv.h"

#include <fmt/format.h>
#include <iterator>
#include <string>
#include <type_traits>
#include <variant>

#include "core/base/atomic_file.h"
#include "core/simulation/records/block_statistic.h"

namespace proveout::cli {

namespace {

std::string header() {
    std::string line = "block,line";
    for (const BlockStatistic& statistic : blockStatistics())
        line.append(",").append(statistic.column);
    return line + '\n';
}

/// Appends nothing if the value is unknown.
void append(std::string& line, const BlockValue& value) {
    std::visit(
        [&line](auto known) {
            if constexpr (!std::is_same_v<decltype(known), std::monostate>)
                fmt::format_to(std::back_inserter(line), "{}", known);
        },
        value);
}

} // namespace

Result<void> writeRecords(const std::filesystem::path& file, const Frame& frame) {
    const ExecutedRun run{frame.statistics, frame.program.get()};
    AtomicFile out(file);
    out.write(header());
    for (std::size_t block = 0; block < frame.block; ++block) {
        std::string line = fmt::format("{},{}", block + 1, frame.program->blockLine(block));
        for (const BlockStatistic& statistic : blockStatistics()) {
            line += ',';
            append(line, statistic.read(run, block));
        }
        out.write(line += '\n');
    }
    return out.commit();
}

} // namespace proveout::cli
