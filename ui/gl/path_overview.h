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

/// The toolpath of a whole program simplified to few lines, none farther from the path than `tolerance()`. A
/// long program takes several calls.
class PathOverview {
public:
    /// Share of the path's size: half a pixel at most if the whole path is visible.
    static constexpr double kShareOfSize = 1.0 / 4000;
    /// A program that needs more lines is processed again with twice the tolerance, and without the lines
    /// that are shorter than that.
    static constexpr std::size_t kMostLines = 150'000;

    /// Starts with another program; null: none. False if the program is the same.
    bool setProgram(std::shared_ptr<const Program> program);
    /// Processes motions until the budget is spent.
    void advance(const UploadBudget& budget);
    [[nodiscard]] bool whole() const { return m_program == nullptr || m_next >= m_program->blockCount(); }

    // Valid once the overview is complete.
    [[nodiscard]] double tolerance() const { return m_tolerance; }
    [[nodiscard]] const Vec3& origin() const { return m_origin; }
    [[nodiscard]] const std::vector<PathVertex>& vertices() const { return m_vertices; } ///< two per line
    /// The number of vertices of the lines that begin before the given number of executed blocks.
    [[nodiscard]] std::size_t verticesBefore(std::size_t block) const;
    /// How often lines of width 1 mm would cover the area of the path, on average.
    [[nodiscard]] double coveragePerMm() const;

private:
    void restart(double tolerance);
    void addSome();
    void add(const Motion& motion, std::uint32_t block);
    void lineTo(const Vec3& point, MotionKind kind, std::uint32_t block);
    void finishLine();
    [[nodiscard]] bool isNearLine(const Vec3& end) const;

    std::shared_ptr<const Program> m_program;
    std::size_t m_next = 0;       ///< next block to process
    std::size_t m_nextMotion = 0; ///< next motion, in m_next or before it
    double m_tolerance = 0;
    bool m_coarse = false; ///< processed again with a larger tolerance
    Vec3 m_origin{0};
    std::vector<PathVertex> m_vertices;
    std::vector<std::uint32_t> m_blocks; ///< block of the first motion of each line
    double m_length = 0;                 ///< total length of the lines, mm

    Vec3 m_from{0};             ///< start of the current line
    std::vector<Vec3> m_passed; ///< points of the current line up to its end; empty: there is no current line
    MotionKind m_kind = MotionKind::rapid;
    std::uint32_t m_block = 0;
};

} // namespace proveout
