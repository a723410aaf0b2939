// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

class QMainWindow;

namespace proveout {

class LayoutMenu;
class PanelDocks;
class PlaybackHub;

/// Sizes and places of a window and its docks, and the speed of playback: arranges them as the chosen layout
/// has them, and keeps in the settings what the user makes of it. Thread: UI.
class WindowState {
public:
    /// All arguments outlive this object.
    WindowState(QMainWindow& window, PanelDocks& docks, const LayoutMenu& layouts, PlaybackHub& playback);

    /// As the chosen layout has it.
    void arrange();
    /// As the settings have it, before the window is shown; else as at the first start.
    void restore();
    /// Where nothing was restored, arranges the docks again: they take their sizes only once the window has
    /// its own.
    void shown();
    void keep() const;

    /// Sizes and places, to be restored later.
    [[nodiscard]] QByteArray layout() const;
    /// Leaves all as it is where `layout` is not one of this version.
    void setLayout(const QByteArray& layout);

private:
    void restorePlayback();

    QMainWindow& m_window;
    PanelDocks& m_docks;
    const LayoutMenu& m_layouts;
    PlaybackHub& m_playback;
    bool m_settled = false; ///< the docks are where the settings, or the user, have them
};

} // namespace proveout
