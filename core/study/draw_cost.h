// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/run/frame.h"

namespace proveout {

/// The cost of showing a frame. The core has no graphics: the workstation plugs in the viewport's own
/// renderer, the command line a rate. Used by one thread, the one that runs the study.
class DrawCost {
public:
    struct Seconds {
        double upload = 0;
        double draw = 0;
    };

    DrawCost() = default;
    DrawCost(const DrawCost&) = delete;
    DrawCost& operator=(const DrawCost&) = delete;
    virtual ~DrawCost() = default;

    /// Starts another run: the graphics side no longer has any of the earlier frames.
    virtual void begin() = 0;
    /// Shows a frame, waits until it is complete, and returns the time that it took.
    [[nodiscard]] virtual Seconds draw(const FramePtr& frame) = 0;
    /// No further run follows on this thread; resources are released.
    virtual void end() {}
};

/// Drawing as the paper describes it (section 1): a card that renders so many triangles per second, and has
/// no other cost. Not measured, so the same on every machine.
class RatedDrawing final : public DrawCost {
public:
    /// The upper end of the paper's figures for an advanced card.
    static constexpr double kPaperRate = 5e6;

    explicit RatedDrawing(double trianglesPerSecond = kPaperRate) : m_rate(trianglesPerSecond) {}
    void begin() override {}
    [[nodiscard]] Seconds draw(const FramePtr& frame) override {
        return {0, static_cast<double>(frame->surface.faces) / m_rate};
    }

private:
    double m_rate;
};

} // namespace proveout
