// SPDX-License-Identifier: GPL-3.0-or-later
// The window as tests work it.
#pragma once

#include <QCoreApplication>
#include <QFile>
#include <QSettings>
#include <QString>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/opened.h"
#include "ui/look/appearance.h"
#include "ui/look/resource_paths.h"
#include "ui/session/session.h"
#include "ui/timeline/timeline_scale.h"
#include "ui/window/main_window.h"

namespace proveout {

inline constexpr int kPatience = 30'000; ///< ms

/// Empty settings, and an empty folder of the application's data, that last as long as this object, in place
/// of the user's.
class OwnSettings {
public:
    OwnSettings() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
        qputenv("XDG_DATA_HOME", QFile::encodeName(m_folder.filePath(QStringLiteral("data"))));
        QCoreApplication::setOrganizationName(QStringLiteral("Proveout"));
        QCoreApplication::setApplicationName(QStringLiteral("Proveout"));
    }

private:
    QTemporaryDir m_folder;
};

/// A window with its session on the settings of the test.
struct Workstation {
    Appearance appearance;
    Session session;
    MainWindow window{session, appearance};

    explicit Workstation(bool sample) {
        window.resize(1280, 800);
        window.show();
        activate();
        if (sample)
            open(sampleJobs().front().file);
    }
    void open(const QString& file) {
        window.files().open(file);
        // A test cannot go on without a frame, and a macro of Qt Test would return from here only.
        if (!openingIsOver(session) ||
            !QTest::qWaitFor([this] { return session.simulation().frame() != nullptr; }, kPatience))
            qFatal("no frame of %s", qPrintable(file));
    }
    /// A shortcut of the window. It reaches an active window only, and after a question the window manager
    /// takes its time to make it active again.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
        activate();
        QTest::keyClick(&window, key, modifiers);
    }
    void activate() {
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window))
            qWarning("the window did not become active");
    }
    TimelineScale& scale() { return *window.findChild<TimelineScale*>(); }
};

} // namespace proveout
