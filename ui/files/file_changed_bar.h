// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "ui/session/session.h"

class QLabel;
class QPushButton;

namespace proveout {

/// "bracket.nc has changed on disk: Reload, Keep My Version, Compare": a bar above the content of the file,
/// used instead of a dialog. The session's signals show and hide it.
class FileChangedBar final : public QFrame {
    Q_OBJECT

public:
    /// The session must outlive the bar.
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
