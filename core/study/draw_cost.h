// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/run/frame.h"

namespace proveout {

/// What it costs to show a frame. The core knows no graphics: the workstation plugs the viewport's own
/// renderer in, the command line a rate. Used by one thread, the one that runs the study.
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

    /// Another run begins: nothing of the frames before is on the graphics side any more.
    virtual void begin() = 0;
    /// Shows a frame, waits until it stands, and tells what that took.
    [[nodiscard]] virtual Seconds draw(const FramePtr& frame) = 0;
    /// No run follows on this thread; what it holds is let go.
    virtual void end() {}
};

/// Drawing as the paper speaks of it (section 1): a card that renders so many triangles per second, and costs
/// nothing else. Not measured, so the same on every machine.
class RatedDrawing final : public DrawCost {
public:
    /// The better end of what the paper grants an advanced card.
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
