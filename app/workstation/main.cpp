// SPDX-License-Identifier: GPL-3.0-or-later
// The workstation: composes session, appearance and window, and reads the command line.
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <string>

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QSettings>
#include <QTemporaryDir>

#include "app/cli/run_command.h"
#include "app/workstation/screenshot_run.h"
#include "app/workstation/study_main.h"
#include "core/base/write_signals.h"
#include "core/verification/findings/command_line_findings.h"
#include "ui/look/appearance.h"
#include "ui/session/session.h"
#include "ui/window/main_window.h"
#include "ui/window/recovery.h"

namespace proveout {
namespace {

constexpr int kUnusable = 3;

struct Options {
    QString file;
    QString screenshot;
    QString panel; ///< for the screenshot; empty: the whole window
    QSize size;
    std::optional<std::size_t> seek; ///< empty: the end of the program
    QString theme;
    QString language;
    QStringList actions;
};

QSize readSize(const QString& text) {
    return {text.section(u'x', 0, 0).toInt(), text.section(u'x', 1, 1).toInt()};
}

void refuse(const std::string& sentence) {
    cli::printFinding("proveout", command_line_finding::kUsage, {sentence});
}

/// Exits the process on --help, --version and usage errors.
Options readOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Proves out three-axis milling programs before they touch metal."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("An NC program or a .proveout job."),
                                 QStringLiteral("[FILE]"));
    const QCommandLineOption screenshot(QStringLiteral("screenshot"),
                                        QStringLiteral("Save a screenshot of the window as PNG and exit."),
                                        QStringLiteral("PNG"));
    const QCommandLineOption panel(
        QStringLiteral("panel"),
        QStringLiteral("Screenshot of one panel only, by the name of its page in the guide: setup, view, …"),
        QStringLiteral("PAGE"));
    const QCommandLineOption size(QStringLiteral("size"),
                                  QStringLiteral("Size of the window, or of the panel."),
                                  QStringLiteral("WxH"));
    const QCommandLineOption seek(QStringLiteral("seek"),
                                  QStringLiteral("Go to the stock after block N, or to the end."),
                                  QStringLiteral("N|end"));
    const QCommandLineOption theme(QStringLiteral("theme"),
                                   QStringLiteral("Theme for this run: system, light or dark."),
                                   QStringLiteral("THEME"));
    const QCommandLineOption language(QStringLiteral("language"),
                                      QStringLiteral("Language for this run: en, ko, de."),
                                      QStringLiteral("CODE"));
    const QCommandLineOption action(QStringLiteral("action"),
                                    QStringLiteral("Run a menu command by its id; repeatable."),
                                    QStringLiteral("ID"));
    parser.addOptions({screenshot, panel, size, seek, theme, language, action});
    parser.process(arguments);

    Options options;
    options.file = parser.positionalArguments().value(0);
    options.screenshot = parser.value(screenshot);
    options.panel = parser.value(panel);
    options.size = readSize(parser.value(size));
    bool isNumber = false;
    const qulonglong block = parser.value(seek).toULongLong(&isNumber);
    if (isNumber)
        options.seek = static_cast<std::size_t>(block);
    options.theme = parser.value(theme);
    options.language = parser.value(language);
    options.actions = parser.values(action);
    if (parser.isSet(screenshot) && options.screenshot.isEmpty()) {
        refuse("--screenshot must not be empty");
        std::exit(kUnusable);
    }
    if (parser.isSet(panel) && options.screenshot.isEmpty()) {
        refuse("--panel needs --screenshot");
        std::exit(kUnusable);
    }
    const bool badSeek = parser.isSet(seek) && !isNumber && parser.value(seek) != QLatin1String("end");
    if (badSeek || (parser.isSet(size) && options.size.isEmpty())) {
        refuse("--seek takes a number or \"end\", --size takes WxH");
        std::exit(kUnusable);
    }
    return options;
}

bool trigger(MainWindow& window, const QStringList& ids) {
    for (const QString& id : ids) {
        QAction* action = window.action(id);
        if (action == nullptr) {
            refuse("There is no command with the id " + id.toStdString());
            return false;
        }
        action->trigger();
    }
    return true;
}

/// Executes the commands of the options. False if a command does not exist.
bool carryOut(MainWindow& window, const Options& options) {
    if (!trigger(window, options.actions))
        return false;
    if (!options.screenshot.isEmpty())
        new ScreenshotRun(window, {options.screenshot, options.seek, options.panel, options.size});
    else if (options.seek)
        window.session().playback().seek(*options.seek);
    return true;
}

int run() {
    const Options options = readOptions(QApplication::arguments());
    QTemporaryDir ownSettings;
    if (!options.screenshot.isEmpty()) {
        // A screenshot must show the defaults and not the user's settings.
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, ownSettings.path());
    }
    Appearance appearance;
    if (!options.theme.isEmpty())
        appearance.overrideTheme(themeFromKey(options.theme));
    if (!options.language.isEmpty())
        appearance.overrideLanguage(options.language);
    Session session;
    MainWindow window(session, appearance);
    // A screenshot must not depend on backups.
    std::optional<Recovery> recovery;
    if (options.screenshot.isEmpty())
        recovery.emplace(window, Recovery::defaultRoot());
    if (!options.size.isEmpty()) {
        window.setWindowState(Qt::WindowNoState); // may be maximised
        window.resize(options.size);
    }
    window.show();
    const auto execute = [&recovery] {
        const int result = QApplication::exec();
        if (recovery)
            recovery->end(); // skipped if an exception was thrown
        return result;
    };
    if (options.file.isEmpty())
        return carryOut(window, options) ? execute() : kUnusable;
    // The commands apply to the content of the file, so they wait until it is open.
    QObject::connect(
        &session.document(), &DocumentHub::opened, &window,
        [&] {
            if (!carryOut(window, options))
                QCoreApplication::exit(kUnusable);
        },
        Qt::SingleShotConnection);
    if (!options.screenshot.isEmpty())
        QObject::connect(&session.problems(), &ProblemsHub::troubled, &window, [&] {
            if (session.document().isOpen())
                return;
            for (const Diagnostic& problem : session.problems().all())
                std::fprintf(stderr, "%s\n", oneLine(problem).c_str());
            QCoreApplication::exit(kUnusable);
        });
    window.files().open(options.file);
    return execute();
}

} // namespace
} // namespace proveout

int main(int argc, char** argv) {
    proveout::reportFailedWrites();
    // Keeps the GL objects of the view when it moves to another window.
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    const bool studies = argc > 1 && std::strcmp(argv[1], "study") == 0;
    const QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Proveout"));
    QCoreApplication::setApplicationName(QStringLiteral("Proveout"));
    QCoreApplication::setApplicationVersion(QStringLiteral(PROVEOUT_VERSION));
    try {
        return studies ? proveout::studyMain(argc, argv) : proveout::run();
    } catch (const std::exception& problem) {
        proveout::cli::printFinding("proveout", proveout::command_line_finding::kCommandFailed,
                                    {problem.what()});
        return proveout::kUnusable;
    }
}
