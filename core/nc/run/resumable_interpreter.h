// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/work_context.h"
#include "core/nc/codes/dialect_guess.h"
#include "core/nc/run/beginnings.h"
#include "core/nc/run/interpreter.h"
#include "core/nc/run/resume_point.h"

namespace proveout {

/// Interprets a text repeatedly while it is edited, or examined block by block: each time from the last point
/// before the first change, and before the block at which to stop or the watched line, at which the earlier
/// run can be resumed. The program equals that of `interpret`. One call at a time, any thread. Keeps the text
/// and the program of the farthest call, and some 50 KB for each of at most `kMostPoints` points.
class ResumableInterpreter {
public:
    static constexpr std::size_t kMostPoints = 64;

    /// `linesPerPoint`: smallest distance between two points.
    explicit ResumableInterpreter(std::size_t linesPerPoint = 4096) : m_leastDistance(linesPerPoint) {}

    [[nodiscard]] std::shared_ptr<const Program> interpret(const NcText& text,
                                                           const InterpretOptions& options,
                                                           const WorkContext& context = {},
                                                           const PublishBeginning& publish = {});

    /// The line, 0-based, from which the last call continued.
    [[nodiscard]] std::size_t resumedAt() const { return m_resumedAt; }

private:
    struct Run {
        NcText text;
        InterpretOptions options;
        DialectGuess guess;
        std::shared_ptr<const Program> program;
    };

    [[nodiscard]] std::size_t unchangedPoints(const NcText& text) const;
    [[nodiscard]] std::size_t pointsBefore(const InterpretOptions& options, std::size_t most) const;
    void forgetFrom(std::size_t index);
    std::size_t keep(ResumePoint point);

    std::size_t m_leastDistance;
    std::size_t m_distance = 0;
    std::optional<Run> m_last;
    std::vector<ResumePoint> m_points; ///< of m_last, by line
    std::size_t m_resumedAt = 0;
};

} // namespace proveout
