// SPDX-License-Identifier: GPL-3.0-or-later
// Random input to the real window, as from a careless user, a cat on the keyboard and another program at the
// same time.
#pragma once

#include <cstdint>
#include <memory>
#include <random>

#include <QFile>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QTimer>

#include "tests/ui/window/workstation.h"

class QFileDialog;

namespace proveout {

/// Operates the whole window by events that are processed like those of a display: through windows, hit
/// testing and shortcuts. Equal seeds give equal choices; their effect also depends on timing. Thread: UI.
class Monkey {
public:
    /// `folder` contains the programs and jobs that are opened, saved and changed by other programs. The log
    /// of all actions is written there too, line by line, so that it survives a crash.
    Monkey(std::uint32_t seed, QString folder);
    ~Monkey();

    /// One random action. Dialogs and menus that it opens are operated and closed too.
    void act();
    /// Why the window is not in a valid state between two actions; empty if it is.
    [[nodiscard]] QString fault() const;
    [[nodiscard]] QString logFile() const { return m_log.fileName(); }
    [[nodiscard]] std::uint64_t actions() const { return m_actions; }

private:
    struct Act;
    static const std::vector<Act>& acts();

    void click();
    void drag();
    void wheel();
    void pressKeys();
    void typeNumber();
    void triggerAction();
    void chooseTab();
    void changeFile();
    void openFile();
    void changeLook();
    void resize();
    void wait();

    void restart();
    void workWhatIsOnTop();
    void workFileDialog(QFileDialog& dialog);
    void note(const QString& what);
    [[nodiscard]] QWidget* target();
    [[nodiscard]] QString anyFile();
    int below(int count);
    bool oneIn(int count) { return below(count) == 0; }

    std::mt19937 m_random;
    QString m_folder;
    QStringList m_files;
    QFile m_log;
    QTimer m_onTop;
    int m_patience = 0; ///< how often the current dialog or menu is still operated
    std::uint64_t m_actions = 0;
    std::unique_ptr<Workstation> m_station;
};

} // namespace proveout
