// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/records_csv.h"

#include <fmt/format.h>
#include <string>

#include "core/base/atomic_file.h"
#include "core/simulation/records/block_records.h"

namespace proveout::cli {

Result<void> writeRecords(const std::filesystem::path& file, const Frame& frame) {
    AtomicFile out(file);
    out.write("block,line,facesShown,facesFull,regionsDirty,regionsDecimated,cutSeconds,decimationSeconds,"
              "removedMm3,maxDepthMm,radialEngagementMm,cuts,firstContact,rateMm3PerMin,feedLengthMm\n");
    for (std::size_t block = 0; block < frame.block; ++block) {
        const BlockStatistics& row = frame.statistics[block];
        const auto rate = removalRate(*frame.program, block, row);
        out.write(fmt::format(
            "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", block + 1, frame.program->blockLine(block),
            row.facesShown, row.facesFull, row.regionsDirty, row.regionsDecimated, row.cutSeconds,
            row.decimationSeconds, row.removedMm3, row.maxDepth, row.radialEngagement, row.cuts() ? 1 : 0,
            isFirstContact(frame.statistics, block) ? 1 : 0, rate ? fmt::format("{}", *rate) : std::string(),
            wayOf(*frame.program, block).feedLength));
    }
    return out.commit();
}

} // namespace proveout::cli
