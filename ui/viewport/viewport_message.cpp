// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>

#include "ui/viewport/foreign_notice.h"
#include "ui/viewport/tool_notice.h"
#include "ui/viewport/viewport.h"

namespace proveout {
namespace {

/// Replaces the 3D view if there is no OpenGL. It still reports frames as drawn to the session, so that paper
/// mode continues.
class ViewportMessage : public QLabel {
public:
    ViewportMessage(Session& session, const QString& reason, QWidget* parent) : QLabel(reason, parent) {
        setAlignment(Qt::AlignCenter);
        setWordWrap(true);
        setTextInteractionFlags(Qt::TextSelectableByMouse);
        setMinimumSize(160, 120);
        connect(&session.playback(), &PlaybackHub::tick, this, [&session](const FramePtr& frame) {
            if (frame != nullptr)
                session.playback().reportDrawn(frame->sequence, 0, 0);
        });
        new ToolNotice(session, this);
        new ForeignNotice(session, this);
    }
};

} // namespace

QWidget* createViewport(Session& session, const GlSupport& support, QWidget* parent) {
    if (!support.usable)
        return new ViewportMessage(session, support.reason, parent);
    return new Viewport(session, support, parent);
}

QWidget* createViewport(Session& session, QWidget* parent) {
    return createViewport(session, probeGl(), parent);
}

} // namespace proveout
