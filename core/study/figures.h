// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of the paper that hold data: one row a figure, and the sweeps that feed them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/study/chart.h"
#include "core/study/study_run.h"

namespace proveout {

enum class SweepKind : std::uint8_t { order, region, allowance, period, method };

/// The words of a chart in the language of who looks at it; English as they stand.
using Words = std::string (*)(const char* text);
[[nodiscard]] std::string englishWords(const char* text);

/// What a study is about: the job, and the parameters that a sweep does not change.
struct StudySubject {
    StudyJob job;
    DecimationParameters base;
    std::string timeLabel; ///< what the seconds of its runs hold, for the axes
    Words words = englishWords;
};

/// One row a sweep: its name on the command line, and the runs that it is made of.
struct SweepRow {
    SweepKind kind;
    const char* key;   ///< on the command line
    const char* title; ///< marked with PROVEOUT_TEXT
    std::vector<StudyPoint> (*points)(const StudySubject&);
};
[[nodiscard]] std::span<const SweepRow> sweepTable();

/// One row a figure. `chart` draws with the runs that are there, so a chart can grow while its sweep runs.
struct FigureRow {
    const char* id;    ///< stable; file names begin with it
    const char* paper; ///< which figures of the paper it stands for
    SweepKind sweep;
    const char* title; ///< marked with PROVEOUT_TEXT
    Chart (*chart)(const StudySubject&, std::span<const StudyRun>);
};
[[nodiscard]] std::span<const FigureRow> figureTable();

/// A set of parameters that the paper's sweeps are run for.
struct StudyVariant {
    std::string key; ///< file names end with it
    DecimationParameters base;
};
/// Every method that works region by region, with its standard values, and the paper's method to the letter
/// (not certified, borders per region); `base` gives the rest.
[[nodiscard]] std::vector<StudyVariant> studyVariants(const DecimationParameters& base);

/// The points of some sweeps, each once, in the order of the table.
[[nodiscard]] std::vector<StudyPoint> pointsOf(std::span<const SweepKind> kinds, const StudySubject& subject);

/// The values that the sweeps go through; region sizes beyond the map are left out.
[[nodiscard]] std::vector<int> studiedRegions(const StudyJob& job);
[[nodiscard]] std::span<const int> studiedPeriods();
[[nodiscard]] std::span<const double> studiedAllowances();

} // namespace proveout
