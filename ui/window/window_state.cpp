// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_state.h"

#include <algorithm>
#include <utility>

#include <QDataStream>
#include <QIODevice>
#include <QMainWindow>
#include <QSettings>

#include "ui/session/playback_hub.h"
#include "ui/window/first_geometry.h"
#include "ui/window/layout_menu.h"
#include "ui/window/panel_docks.h"

namespace proveout {

namespace {

constexpr int kLayoutVersion = 5; // increase it when a dock is renamed, so that older layouts are ignored
const QString kGeometryKey = QStringLiteral("window/geometry");
const QString kStateKey = QStringLiteral("window/state");
const QString kWidthChosenKey = QStringLiteral("window/editor-width-chosen");
const QString kPlayByKey = QStringLiteral("playback/by");
const QString kSpeedKey = QStringLiteral("playback/speed");

} // namespace

WindowState::WindowState(QMainWindow& window, PanelDocks& docks, const LayoutMenu& layouts,
                         PlaybackHub& playback)
    : m_window(window), m_docks(docks), m_layouts(layouts), m_playback(playback) {}

void WindowState::arrange() {
    const DockLayout& layout = m_layouts.present();
    m_docks.arrange(layout);
    m_playback.setPlayBy(layout.playBy);
    m_playback.setSpeed(layout.speed * unitSpeed(layout.playBy));
}

void WindowState::restore() {
    const QSettings settings;
    if (!m_window.restoreGeometry(settings.value(kGeometryKey).toByteArray()))
        applyFirstGeometry(m_window);
    arrange();
    m_settled = m_docks.restore(settings.value(kStateKey).toByteArray(), kLayoutVersion);
    if (!m_settled)
        return;
    m_docks.setWidthChosen(settings.value(kWidthChosenKey, true).toBool());
    restorePlayback();
}

void WindowState::restorePlayback() {
    const QSettings settings;
    const Playback& state = m_playback.state();
    const int by = settings.value(kPlayByKey, static_cast<int>(state.by)).toInt();
    const double speed = settings.value(kSpeedKey, state.unitsPerSecond).toDouble();
    m_playback.setPlayBy(static_cast<PlayBy>(std::clamp(by, 0, static_cast<int>(PlayBy::time))));
    if (speed > 0)
        m_playback.setSpeed(speed);
}

void WindowState::shown() {
    if (!std::exchange(m_settled, true))
        arrange();
}

void WindowState::keep() const {
    QSettings settings;
    settings.setValue(kGeometryKey, m_window.saveGeometry());
    settings.setValue(kStateKey, m_window.saveState(kLayoutVersion));
    settings.setValue(kWidthChosenKey, m_docks.isWidthChosen());
    settings.setValue(kPlayByKey, static_cast<int>(m_playback.state().by));
    settings.setValue(kSpeedKey, m_playback.state().unitsPerSecond);
}

QByteArray WindowState::layout() const {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << m_window.saveGeometry() << m_window.saveState(kLayoutVersion) << m_docks.isWidthChosen();
    return bytes;
}

void WindowState::setLayout(const QByteArray& layout) {
    QByteArray geometry;
    QByteArray state;
    QDataStream stream(layout);
    bool widthChosen = true;
    stream >> geometry >> state >> widthChosen;
    if (!m_docks.restore(state, kLayoutVersion))
        return;
    m_window.restoreGeometry(geometry);
    m_docks.setWidthChosen(widthChosen);
    m_settled = true;
}

} // namespace proveout
