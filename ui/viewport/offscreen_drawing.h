// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/study/draw_cost.h"

class QThread;

namespace proveout {

/// Draws frames with the viewport's renderer into an invisible image and measures the cost. Needs a display.
/// Created and destroyed on the GUI thread; used there, or on the thread that it was moved to until end() is
/// called on that thread.
class OffscreenDrawing final : public DrawCost {
public:
    /// Images of width × height pixels that the stock fills, seen from a corner. Errors: OpenGL 3.3 is not
    /// available.
    /// `thread`: the thread that draws; null for the calling one.
    [[nodiscard]] static Result<std::unique_ptr<DrawCost>> create(int width, int height,
                                                                  QThread* thread = nullptr);
    ~OffscreenDrawing() override;

    void begin() override;
    void end() override;
    [[nodiscard]] Seconds draw(const FramePtr& frame) override;

private:
    struct State;
    explicit OffscreenDrawing(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

} // namespace proveout
