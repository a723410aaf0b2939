// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/sweep.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace proveout {

namespace {

/// The median run of the runs of one point.
SweptPoint summedUp(std::vector<StudyRun> runs) {
    std::vector<double> totals;
    totals.reserve(runs.size());
    for (const StudyRun& run : runs)
        totals.push_back(run.seconds.total());
    const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
    std::nth_element(runs.begin(), middle, runs.end(), [](const StudyRun& a, const StudyRun& b) {
        return a.seconds.total() < b.seconds.total();
    });
    return {std::move(*middle), measured(totals)};
}

} // namespace

Result<std::vector<SweptPoint>> runSweep(const StudyJob& job, std::span<const StudyPoint> points,
                                         const SweepOptions& options, const WorkContext& context) {
    const auto rounds = static_cast<std::size_t>(std::max(1, options.repeats));
    const auto all = static_cast<double>(rounds * points.size());
    std::vector<std::vector<StudyRun>> runs(points.size());
    std::size_t done = 0;
    for (std::size_t round = 0; round < rounds; ++round)
        for (std::size_t k = 0; k < points.size(); ++k) {
            const std::size_t place = (k + round) % points.size();
            const WorkContext one{context.stop, [&](double share) {
                                      context.report((static_cast<double>(done) + share) / all);
                                  }};
            auto run = runStudy(job, points[place], options.drawing, options.drawEvery, one);
            if (!run)
                return tl::unexpected(std::move(run.error()));
            ++done;
            if (round == 0 && options.finished)
                options.finished(*run);
            assert(round == 0 || run->count == runs[place].front().count);
            runs[place].push_back(std::move(*run));
        }
    std::vector<SweptPoint> swept;
    swept.reserve(runs.size());
    for (std::vector<StudyRun>& ofPoint : runs)
        swept.push_back(summedUp(std::move(ofPoint)));
    return swept;
}

} // namespace proveout
