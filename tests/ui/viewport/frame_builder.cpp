// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/viewport/frame_builder.h"

#include <algorithm>

namespace proveout {
namespace {
Grid gridOf(const StockBox& stock, double spacing) {
    return makeGrid(stock, spacing).value();
}
} // namespace

FrameBuilder::FrameBuilder(const StockBox& stock, double spacing, const DecimationParameters& parameters)
    : m_zmap(stock, gridOf(stock, spacing)),
      m_surface(m_zmap.grid().nx, m_zmap.grid().ny, whileCutting(parameters)) {
    m_frame.parameters = parameters;
}

void FrameBuilder::cut(const IndexRect& rect, const std::function<double(double, double)>& height) {
    const int tilesX = m_zmap.tilesX();
    for (int j = rect.j0; j < rect.j1; ++j)
        for (int i = rect.i0; i < rect.i1; ++i) {
            const double wanted = height(grid().x(i), grid().y(j)) - m_zmap.stock().topZ();
            const auto lowered = std::max(static_cast<float>(wanted), m_zmap.floor());
            const auto index = static_cast<std::size_t>((j / Tile::kSize) * tilesX + i / Tile::kSize);
            if (lowered < m_zmap.tile(index).at(i % Tile::kSize, j % Tile::kSize))
                m_zmap.tileForWriting(index).at(i % Tile::kSize, j % Tile::kSize) = lowered;
        }
    m_surface.touch(rect);
}

void FrameBuilder::cutAll(const std::function<double(double, double)>& height) {
    cut({0, 0, grid().nx, grid().ny}, height);
}

void FrameBuilder::decimate() {
    m_surface.decimateDirty(m_zmap.snapshot());
}

FramePtr FrameBuilder::frame() {
    ++m_frame.sequence;
    m_frame.zmap = m_zmap.snapshot();
    m_frame.surface = m_surface.snapshot();
    return std::make_shared<const Frame>(m_frame);
}

void FrameBuilder::setProgram(std::shared_ptr<const Program> program, std::size_t block) {
    m_frame.program = std::move(program);
    m_frame.block = block;
}

void FrameBuilder::setCutter(const Cutter& cutter, const Vec3& tip) {
    changedSetup()->tools.set(1, cutter);
    m_frame.tool = 1;
    m_frame.cutterKnown = true;
    m_frame.cutterPosition = tip;
}

void FrameBuilder::setFixtures(const Fixtures& fixtures) {
    changedSetup()->fixtures = fixtures;
}

std::shared_ptr<Setup> FrameBuilder::changedSetup() {
    auto setup = std::make_shared<Setup>(m_frame.setup ? *m_frame.setup : Setup());
    m_frame.setup = setup;
    return setup;
}

} // namespace proveout
