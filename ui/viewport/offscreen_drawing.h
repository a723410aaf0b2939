// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/study/draw_cost.h"

class QThread;

namespace proveout {

/// Draws frames with the viewport's own renderer into a picture that nobody sees, and tells what that took.
/// Needs a display. Made and destroyed on the GUI thread; used there, or on the thread that it was moved to
/// until end() is called on that one.
class OffscreenDrawing final : public DrawCost {
public:
    /// Pictures of width × height pixels, the stock seen from its corner and filling them. Errors: no
    /// OpenGL 3.3.
    /// `thread`: the one that draws; null for the calling one.
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
