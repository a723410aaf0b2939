// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of the paper that show data: one row per figure, and the sweeps that supply them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/study/chart.h"
#include "core/study/study_run.h"

namespace proveout {

enum class SweepKind : std::uint8_t { order, region, allowance, period, method };

/// Translates the texts of a chart into the viewer's language; English ones are returned unchanged.
using Words = std::string (*)(const char* text);
[[nodiscard]] std::string englishWords(const char* text);

/// The subject of a study: the job, and the parameters that a sweep does not change.
struct StudySubject {
    StudyJob job;
    DecimationParameters base;
    std::string timeLabel; ///< what the seconds of its runs include, for the axes
    Words words = englishWords;
};

/// One row per sweep: its name on the command line, and its runs.
struct SweepRow {
    SweepKind kind;
    const char* key;   ///< on the command line
    const char* title; ///< marked with PROVEOUT_TEXT
    std::vector<StudyPoint> (*points)(const StudySubject&);
};
[[nodiscard]] std::span<const SweepRow> sweepTable();

/// One row per figure. `chart` draws the runs that exist, so a chart can grow while its sweep runs.
struct FigureRow {
    const char* id;    ///< stable; the beginning of file names
    const char* paper; ///< the figures of the paper that it corresponds to
    SweepKind sweep;
    const char* title; ///< marked with PROVEOUT_TEXT
    Chart (*chart)(const StudySubject&, std::span<const StudyRun>);
};
[[nodiscard]] std::span<const FigureRow> figureTable();

/// A set of parameters for which the paper's sweeps are run.
struct StudyVariant {
    std::string key; ///< the end of file names
    DecimationParameters base;
};
/// Every method that works region by region, with its default values, and the exact method of the paper
/// (not certified, borders per region); other values come from `base`.
[[nodiscard]] std::vector<StudyVariant> studyVariants(const DecimationParameters& base);

/// The points of several sweeps, each once, in the order of the table.
[[nodiscard]] std::vector<StudyPoint> pointsOf(std::span<const SweepKind> kinds, const StudySubject& subject);

/// The values that the sweeps use; region sizes larger than the map are omitted.
[[nodiscard]] std::vector<int> studiedRegions(const StudyJob& job);
[[nodiscard]] std::span<const int> studiedPeriods();
[[nodiscard]] std::span<const double> studiedAllowances();

} // namespace proveout
