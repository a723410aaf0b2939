// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_table.h"

#include <array>
#include <cstddef>
#include <vector>

#include <QAction>
#include <QCoreApplication>

#include "ui/breakpoints/breakpoints_panel.h"
#include "ui/control/control_panel.h"
#include "ui/editor/editor_panel.h"
#include "ui/findings/problems_panel.h"
#include "ui/part/part_panel.h"
#include "ui/plots/plots_panel.h"
#include "ui/readout/problem_list.h"
#include "ui/session/playback_commands.h"
#include "ui/session/session.h"
#include "ui/setup/setup_panel.h"
#include "ui/study/study_panel.h"
#include "ui/timeline/timeline_panel.h"
#include "ui/tuning/tuning_panel.h"
#include "ui/viewport/offscreen_drawing.h"

namespace proveout {

namespace {

constexpr QSize kStudyPicture{1280, 800};

/// A panel that needs only the session.
template<class Panel>
QWidget* make(const PanelParts& parts, QWidget* parent) {
    return new Panel(parts.session, parent);
}

QWidget* makePlots(const PanelParts& parts, QWidget* parent) {
    auto* plots = new PlotsPanel(parts.session, parent);
    for (QAction* action : parts.playback.actions().all()) {
        if (!action->isSeparator())
            plots->addKeys(action);
    }
    return plots;
}

QWidget* makeTimeline(const PanelParts& parts, QWidget* parent) {
    return new TimelinePanel(parts.session, parts.playback, parent);
}

/// The study panel draws with the viewport's renderer; this keeps the two panels independent of each other.
Result<std::unique_ptr<DrawCost>> makeStudyDrawing(QThread* thread) {
    return OffscreenDrawing::create(kStudyPicture.width(), kStudyPicture.height(), thread);
}

QWidget* makeStudy(const PanelParts& parts, QWidget* parent) {
    return new StudyPanel(parts.session, makeStudyDrawing, parent);
}

QString withModified(const QString& title, bool modified) {
    return modified ? title + u'*' : title;
}

QString markText(const QString& title, const Session& session) {
    return withModified(title, session.document().text().modified);
}

QString markJob(const QString& title, const Session& session) {
    return withModified(title, session.document().jobModified());
}

QString countProblems(const QString& title, const Session& session) {
    const std::vector<CheckFinding> problems = problemList(session);
    const std::size_t count = problems.size() + outdatedProblems(session, problems).size();
    return count == 0 ? title : QStringLiteral("%1 (%2)").arg(title).arg(count);
}

QString countIslands(const QString& title, const Session& session) {
    const auto& report = session.check().report();
    const std::size_t count = report && report->part ? report->part->gouges + report->part->excesses : 0;
    return count == 0 ? title : QStringLiteral("%1 (%2)").arg(title).arg(count);
}

} // namespace

std::span<const PanelRow> panelTable() {
    static constexpr std::array kRows{
        PanelRow{.id = kProgramPanel,
                 .title = QT_TRANSLATE_NOOP("Docks", "NC Program"),
                 .icon = "path",
                 .keys = "Ctrl+1",
                 .make = make<EditorPanel>,
                 .area = DockArea::left,
                 .fitted = true,
                 .menu = PanelMenu::edit,
                 .marked = markText},
        PanelRow{.id = kSetupPanel,
                 .title = QT_TRANSLATE_NOOP("Docks", "Setup"),
                 .icon = "stock",
                 .keys = "Ctrl+2",
                 .make = make<SetupPanel>,
                 .area = DockArea::right,
                 .editsJob = true,
                 .marked = markJob},
        PanelRow{.id = kTuningPanel,
                 .title = QT_TRANSLATE_NOOP("Docks", "Tuning"),
                 .icon = "tuning",
                 .keys = "Ctrl+3",
                 .make = make<TuningPanel>,
                 .area = DockArea::right,
                 .editsJob = true},
        PanelRow{.id = "dock-plots",
                 .title = QT_TRANSLATE_NOOP("Docks", "Plots"),
                 .icon = "plots",
                 .keys = "Ctrl+4",
                 .make = makePlots,
                 .menu = PanelMenu::view,
                 .submenu = QT_TRANSLATE_NOOP("Menus", "P&lots")},
        PanelRow{.id = kProblemsPanel,
                 .title = QT_TRANSLATE_NOOP("Docks", "Problems"),
                 .icon = "problems",
                 .keys = "Ctrl+5",
                 .make = make<ProblemsPanel>,
                 .menu = PanelMenu::edit,
                 .marked = countProblems},
        PanelRow{.id = "dock-timeline",
                 .title = QT_TRANSLATE_NOOP("Docks", "Timeline"),
                 .icon = "play",
                 .keys = "Ctrl+6",
                 .make = makeTimeline,
                 .titleBar = false},
        PanelRow{.id = "dock-study",
                 .title = QT_TRANSLATE_NOOP("Docks", "Study"),
                 .icon = "study",
                 .keys = "Ctrl+7",
                 .make = makeStudy},
        PanelRow{.id = "dock-control",
                 .title = QT_TRANSLATE_NOOP("Docks", "Control"),
                 .icon = "settings",
                 .keys = "Ctrl+8",
                 .make = make<ControlPanel>,
                 .area = DockArea::right},
        PanelRow{.id = "dock-breakpoints",
                 .title = QT_TRANSLATE_NOOP("Docks", "Breakpoints"),
                 .icon = "breakpoint",
                 .keys = "Ctrl+9",
                 .make = make<BreakpointsPanel>},
        PanelRow{.id = "dock-part",
                 .title = QT_TRANSLATE_NOOP("Docks", "Part"),
                 .icon = "part",
                 .keys = "Ctrl+0",
                 .make = make<PartPanel>,
                 .editsJob = true,
                 .marked = countIslands},
    };
    return kRows;
}

} // namespace proveout
