// SPDX-License-Identifier: GPL-3.0-or-later
// The window for tests.
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

/// Empty settings and an empty application data folder while this object exists, instead of the user's.
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

/// A window with its session, using the settings of the test.
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
        // A test cannot continue without a frame, and a macro of Qt Test would only return from this
        // function.
        if (!openingIsOver(session) ||
            !QTest::qWaitFor([this] { return session.simulation().frame() != nullptr; }, kPatience))
            qFatal("no frame of %s", qPrintable(file));
    }
    /// Presses a shortcut of the window. Only an active window receives it, and after a question the window
    /// manager needs some time to activate it again.
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
