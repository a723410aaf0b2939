// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "ui/session/session.h"

class QLabel;
class QPushButton;

namespace proveout {

/// "bracket.nc has changed on disk: Reload, Keep My Version, Compare", above what the file holds instead of a
/// dialog. Comes and goes by itself with the signals of the session.
class FileChangedBar final : public QFrame {
    Q_OBJECT

public:
    /// The session outlives the bar.
    FileChangedBar(Session& session, FilePart part, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] QString file() const;
    void report();
    void reload();
    void keep();
    void compare();
    void retranslate();
    void writeSentence();

    Session& m_session;
    FilePart m_part;
    QLabel* m_text;
    QPushButton* m_reload;
    QPushButton* m_keep;
    QPushButton* m_compare;
};

} // namespace proveout
