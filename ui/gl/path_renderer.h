// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ui/gl/path_lines.h"
#include "ui/gl/path_overview.h"
#include "ui/gl/scene_light.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/vertex_buffer.h"

namespace proveout {

/// Draws the toolpath. All methods need the same context to be current.
class PathRenderer {
public:
    /// The path near the cutter is at most this many blocks before and after it.
    static constexpr std::size_t kBlocksBehind = 80;
    static constexpr std::size_t kBlocksAhead = 160;
    /// Programs with more motions show only the path near the cutter, because its lines must be created
    /// within a frame.
    static constexpr std::size_t kMostWholeMotions = 200'000;

    PathRenderer() : m_program({{"line.vert"}, "line.geom", {"line.frag"}, {}}) {}

    [[nodiscard]] bool valid() const { return m_program.valid(); }
    /// The program being run, and the number of blocks that have been executed.
    void setPosition(std::shared_ptr<const Program> program, std::size_t block);
    /// `stockOrigin`: the origin of stock coordinates, in program coordinates.
    void draw(Gl& gl, const StockView& view, const SceneOptions& options, const Vec3& stockOrigin);
    /// Draws the part of the whole toolpath that is hidden by what has been drawn, dimmed. The depth of each
    /// drawn pixel must have been written. Draws nothing before advanceOverview() is complete.
    void drawHidden(Gl& gl, const StockView& view, const SceneOptions& options, const Vec3& stockOrigin);
    /// Creates the lines of drawHidden().
    void advanceOverview(const UploadBudget& budget) { m_overview.advance(budget); }
    [[nodiscard]] bool overviewPending() const { return !m_overview.whole(); }
    void release(Gl& gl);

private:
    void prepare(Gl& gl, bool whole);
    void begin(Gl& gl, const StockView& view, const Vec3& shift);
    static void end(Gl& gl);
    void drawRun(Gl& gl, VertexBuffer& vertices, const SceneOptions& options, std::size_t first,
                 std::size_t last, float opacity);

    ShaderProgram m_program;
    VertexBuffer m_vertices;
    std::shared_ptr<const Program> m_path;
    std::size_t m_block = 0;
    PathLines m_lines;
    std::shared_ptr<const Program> m_shownPath;
    std::size_t m_shownFirst = 0;
    std::size_t m_shownLast = 0;
    PathOverview m_overview;
    VertexBuffer m_overviewVertices;
    bool m_overviewUploaded = false;
};

} // namespace proveout
