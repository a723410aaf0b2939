// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/simulation/run/frame.h"

namespace proveout {

/// Builds frames by hand: cuts a z-map by a formula and decimates on request.
class FrameBuilder {
public:
    FrameBuilder(const StockBox& stock, double spacing, const DecimationParameters& parameters = {});

    [[nodiscard]] const Grid& grid() const { return m_zmap.grid(); }
    /// Lowers the points of `rect` to height(x, y) (program coordinates) if that is lower.
    void cut(const IndexRect& rect, const std::function<double(double, double)>& height);
    void cutAll(const std::function<double(double, double)>& height);
    void decimate();

    /// The frame for a viewer; without program and cutter unless they are set.
    [[nodiscard]] FramePtr frame();
    void setProgram(std::shared_ptr<const Program> program, std::size_t block);
    void setCutter(const Cutter& cutter, const Vec3& tip);
    void setFixtures(const Fixtures& fixtures);

private:
    /// The setup of the frames, for a change.
    [[nodiscard]] std::shared_ptr<Setup> changedSetup();

    Frame m_frame;
    ZMap m_zmap;
    Surface m_surface;
};

} // namespace proveout
