// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/nc/program/program.h"
#include "ui/gl/path_lines.h"
#include "ui/gl/upload_budget.h"

namespace proveout {

/// The toolpath of a whole program in few lines, none farther from the path than `tolerance()`. A long
/// program takes several calls.
class PathOverview {
public:
    /// Of half a pixel and less where the whole path is in the picture.
    static constexpr double kShareOfSize = 1.0 / 4000;
    /// A program that needs more is taken again with twice the tolerance, and without the lines that are
    /// shorter than that.
    static constexpr std::size_t kMostLines = 150'000;

    /// Begins with another program; null: none. False where it is the same one.
    bool setProgram(std::shared_ptr<const Program> program);
    /// Takes motions until the budget is spent.
    void advance(const UploadBudget& budget);
    [[nodiscard]] bool whole() const { return m_program == nullptr || m_next >= m_program->blockCount(); }

    // Once it is whole.
    [[nodiscard]] double tolerance() const { return m_tolerance; }
    [[nodiscard]] const Vec3& origin() const { return m_origin; }
    [[nodiscard]] const std::vector<PathVertex>& vertices() const { return m_vertices; } ///< two a line
    /// Of the lines that begin before a number of executed blocks.
    [[nodiscard]] std::size_t verticesBefore(std::size_t block) const;
    /// How often the lines of width 1 mm cover what is below them, on average.
    [[nodiscard]] double coveragePerMm() const;

private:
    void restart(double tolerance);
    void addSome();
    void add(const Motion& motion, std::uint32_t block);
    void lineTo(const Vec3& point, MotionKind kind, std::uint32_t block);
    void finishLine();
    [[nodiscard]] bool isNearLine(const Vec3& end) const;

    std::shared_ptr<const Program> m_program;
    std::size_t m_next = 0;       ///< block
    std::size_t m_nextMotion = 0; ///< of it, or before it
    double m_tolerance = 0;
    bool m_coarse = false; ///< taken again
    Vec3 m_origin{0};
    std::vector<PathVertex> m_vertices;
    std::vector<std::uint32_t> m_blocks; ///< of the first motion of each line
    double m_length = 0;                 ///< of all lines, mm

    Vec3 m_from{0};             ///< of the line that is being drawn
    std::vector<Vec3> m_passed; ///< its points up to its end; empty: there is no line
    MotionKind m_kind = MotionKind::rapid;
    std::uint32_t m_block = 0;
};

} // namespace proveout
