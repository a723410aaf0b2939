// SPDX-License-Identifier: GPL-3.0-or-later
// One run of a program as in the paper's case studies: every block is cut, decimated when due, and shown.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/work_context.h"
#include "core/study/draw_cost.h"

namespace proveout {

/// The job that is studied. Value type.
struct StudyJob {
    std::shared_ptr<const Program> program;
    std::shared_ptr<const Setup> setup;
};

/// The work of a run. It depends only on program, setup and parameters, never on the machine.
struct WorkCount {
    std::uint64_t frames = 0;           ///< blocks shown
    std::uint64_t faces = 0;            ///< triangles shown, summed over the frames
    std::uint64_t regionsShown = 0;     ///< regions, summed over the frames
    std::uint64_t moments = 0;          ///< times that something was decimated, including the start
    std::uint64_t startRegions = 0;     ///< regions decimated before the first block
    std::uint64_t regionsDecimated = 0; ///< regions decimated, including those of the start
    std::uint64_t facesMade = 0;        ///< triangles of the meshes that these decimations made

    friend bool operator==(const WorkCount&, const WorkCount&) = default;
};

/// Where the time of a run went, seconds of wall time.
struct PhaseSeconds {
    double cut = 0;
    double decimate = 0; ///< including the uncut stock at the start
    double upload = 0;
    double draw = 0;
    double other = 0; ///< finding the regions that were cut, and making the frames

    [[nodiscard]] double total() const { return cut + decimate + upload + draw + other; }
};

/// One block of a run.
struct StudyRow {
    std::uint32_t faces = 0; ///< triangles shown
    float seconds = 0;       ///< cutting, decimation, upload and drawing
};

/// One run of a sweep. Value type.
struct StudyPoint {
    static constexpr std::size_t kAllBlocks = static_cast<std::size_t>(-1);

    DecimationParameters parameters;
    std::size_t blocks = kAllBlocks; ///< how many blocks of the program are run

    friend bool operator==(const StudyPoint&, const StudyPoint&) = default;
};

struct StudyRun {
    StudyPoint point;
    WorkCount count;
    PhaseSeconds seconds;
    std::vector<StudyRow> rows; ///< row k: block k + 1
};

/// Runs the program. `drawing` may be null: then nothing is drawn. `drawEvery` > 1 draws one of every n
/// blocks, for software renderers; the others are counted with the seconds of the last one drawn. Errors: as
/// Simulation::create(); "study-stopped" if the context was stopped. Blocks the calling thread.
[[nodiscard]] Result<StudyRun> runStudy(const StudyJob& job, const StudyPoint& point, DrawCost* drawing,
                                        std::size_t drawEvery = 1, const WorkContext& context = {});

} // namespace proveout
