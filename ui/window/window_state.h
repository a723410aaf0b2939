// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

class QMainWindow;

namespace proveout {

class LayoutMenu;
class PanelDocks;
class PlaybackHub;

/// Sizes and positions of a window and its docks, and the playback speed: arranges them according to the
/// chosen layout, and stores the user's changes in the settings. Thread: UI.
class WindowState {
public:
    /// All arguments must outlive this object.
    WindowState(QMainWindow& window, PanelDocks& docks, const LayoutMenu& layouts, PlaybackHub& playback);

    /// Arranges the docks according to the chosen layout.
    void arrange();
    /// Restores the state from the settings before the window is shown, or that of the first start.
    void restore();
    /// If nothing was restored, arranges the docks again, because they get their sizes only once the window
    /// has its own.
    void shown();
    void keep() const;

    /// Sizes and positions, for restoring them later.
    [[nodiscard]] QByteArray layout() const;
    /// Does nothing if `layout` was stored by another version.
    void setLayout(const QByteArray& layout);

private:
    void restorePlayback();

    QMainWindow& m_window;
    PanelDocks& m_docks;
    const LayoutMenu& m_layouts;
    PlaybackHub& m_playback;
    bool m_settled = false; ///< the docks are arranged as in the settings or by the user
};

} // namespace proveout
