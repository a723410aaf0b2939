// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/playback_commands.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/session/measure_key.h"

namespace proveout {

namespace {

constexpr const char* kContext = "SimulateCommands";
constexpr std::ptrdiff_t kManyBlocks = 10;

void changeSpeed(Session& session, int direction) {
    const double unit = unitSpeed(session.playback().state().by) / kUnitBlocksPerSecond;
    session.playback().setSpeed(
        unit * neighbourSpeed(session.playback().state().unitsPerSecond / unit, direction),
        session.playback().state().everyBlock);
}

const std::array<Command<Session>, 18> kCommands{{
    {"play", QT_TRANSLATE_NOOP("SimulateCommands", "&Play"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Play or pause the program"), "play", "Space", Reach::window,
     [](Session& session) { session.playback().togglePlay(); }},
    {"play-from-start", QT_TRANSLATE_NOOP("SimulateCommands", "Play from Sta&rt"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Go to the uncut stock and play"), "", "F5", Reach::window,
     [](Session& session) {
         session.playback().pause();
         session.playback().seek(0);
         session.playback().play();
     }},
    {"stop", QT_TRANSLATE_NOOP("SimulateCommands", "&Stop"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Stop and go back to the uncut stock"), "stop", "Shift+F5",
     Reach::window,
     [](Session& session) {
         session.playback().pause();
         session.playback().seek(0);
     }},
    separator<Session>(),
    {"to-start", QT_TRANSLATE_NOOP("SimulateCommands", "Go to St&art"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Go to the uncut stock"), "to-start", "Home", Reach::focus,
     [](Session& session) { session.playback().seek(0); }},
    {"step-back", QT_TRANSLATE_NOOP("SimulateCommands", "Step &Back"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Go back by one block"), "step-back", "Left", Reach::focus,
     [](Session& session) { session.playback().step(-1); }},
    {"step-forward", QT_TRANSLATE_NOOP("SimulateCommands", "Step &Forward"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Execute the next block"), "step-forward", "Right", Reach::focus,
     [](Session& session) { session.playback().step(1); }},
    {"to-end", QT_TRANSLATE_NOOP("SimulateCommands", "Go to &End"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Go to the end of the program"), "to-end", "End", Reach::focus,
     [](Session& session) { session.playback().seek(session.program().blockCount()); }},
    {"step-back-10", QT_TRANSLATE_NOOP("SimulateCommands", "Back by 10 Blocks"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Go back by 10 blocks"), "", "Shift+Left", Reach::focus,
     [](Session& session) { session.playback().step(-kManyBlocks); }},
    {"step-forward-10", QT_TRANSLATE_NOOP("SimulateCommands", "Forward by 10 Blocks"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Execute the next 10 blocks"), "", "Shift+Right", Reach::focus,
     [](Session& session) { session.playback().step(kManyBlocks); }},
    {"previous-tool-change", QT_TRANSLATE_NOOP("SimulateCommands", "Previous &Tool Change"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Go back to the previous tool change"), "", "Ctrl+Left",
     Reach::focus, [](Session& session) { session.playback().stepToToolChange(-1); }},
    {"next-tool-change", QT_TRANSLATE_NOOP("SimulateCommands", "Next T&ool Change"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Go to the next tool change"), "", "Ctrl+Right", Reach::focus,
     [](Session& session) { session.playback().stepToToolChange(1); }},
    {"jump-back", QT_TRANSLATE_NOOP("SimulateCommands", "Back to Previo&us Position"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Go back to the position before the jump to a cutting block"), "",
     "Backspace", Reach::focus, [](Session& session) { session.navigation().returnFromJump(); }},
    separator<Session>(),
    {"slower", QT_TRANSLATE_NOOP("SimulateCommands", "S&lower"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Play slower"), "slower", "-", Reach::focus,
     [](Session& session) { changeSpeed(session, -1); }},
    {"faster", QT_TRANSLATE_NOOP("SimulateCommands", "Fa&ster"),
     QT_TRANSLATE_NOOP("SimulateCommands", "Play faster"), "faster", "+; =", Reach::focus,
     [](Session& session) { changeSpeed(session, 1); }},
    separator<Session>(),
    {"measure", QT_TRANSLATE_NOOP("SimulateCommands", "&Measure Whole Program"),
     QT_TRANSLATE_NOOP(
         "SimulateCommands",
         "Execute each block that was not played yet, and measure its triangles and times for the plots"),
     "", kMeasureKey, Reach::window, [](Session& session) { session.playback().measure(); }},
}};

} // namespace

PlaybackCommands::PlaybackCommands(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_actions(session, kContext, kCommands, this) {
    connect(&session.playback(), &PlaybackHub::changed, this, &PlaybackCommands::update);
    connect(&session.program(), &ProgramHub::changed, this, &PlaybackCommands::update);
    update();
}

void PlaybackCommands::retranslate() {
    m_actions.retranslate();
    update();
}

void PlaybackCommands::update() {
    QAction* play = m_actions.find("play");
    const bool playing = m_session.playback().state().playing;
    play->setIcon(icon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
    play->setText(
        QCoreApplication::translate(kContext, playing ? QT_TRANSLATE_NOOP("SimulateCommands", "&Pause")
                                                      : QT_TRANSLATE_NOOP("SimulateCommands", "&Play")));
    const bool moves = m_session.program().blockCount() > 0;
    for (QAction* action : m_actions.all())
        action->setEnabled(moves);
    m_actions.find("jump-back")->setEnabled(moves && m_session.navigation().canReturn());
}

const std::array<double, kSpeedCount>& speeds() {
    static constexpr std::array<double, kSpeedCount - 1> kFactors{0.1, 0.2, 0.5, 1,   2,   5,   10,
                                                                  20,  50,  100, 200, 300, 500, 1000};
    static const std::array<double, kSpeedCount> kSpeeds = [] {
        std::array<double, kSpeedCount> made{};
        std::transform(kFactors.begin(), kFactors.end(), made.begin(),
                       [](double factor) { return factor * kUnitBlocksPerSecond; });
        made.back() = std::numeric_limits<double>::infinity();
        return made;
    }();
    return kSpeeds;
}

double neighbourSpeed(double blocksPerSecond, int direction) {
    const auto& all = speeds();
    const auto nearest = std::lower_bound(all.begin(), all.end(), blocksPerSecond * (1 - 1e-9));
    const auto index = nearest - all.begin() + direction;
    return all[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, kSpeedCount - 1))];
}

} // namespace proveout
