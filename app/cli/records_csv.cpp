// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/records_csv.h"

#include <fmt/format.h>

#include "core/base/atomic_file.h"

namespace proveout::cli {

Result<void> writeRecords(const std::filesystem::path& file, const Frame& frame) {
    AtomicFile out(file);
    out.write("block,line,facesShown,facesFull,regionsDirty,regionsDecimated,cutSeconds,decimationSeconds,"
              "removedMm3,maxDepthMm\n");
    for (std::size_t block = 0; block < frame.block; ++block) {
        const BlockStatistics& row = frame.statistics[block];
        out.write(fmt::format("{},{},{},{},{},{},{},{},{},{}\n", block + 1, frame.program->blockLine(block),
                              row.facesShown, row.facesFull, row.regionsDirty, row.regionsDecimated,
                              row.cutSeconds, row.decimationSeconds, row.removedMm3, row.maxDepth));
    }
    return out.commit();
}

} // namespace proveout::cli
