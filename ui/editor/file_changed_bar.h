// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace proveout {

/// "File changed on disk: Reload / Keep mine", above the text instead of a dialog.
class FileChangedBar final : public QFrame {
    Q_OBJECT

public:
    explicit FileChangedBar(QWidget* parent);

signals:
    void reloadWanted();
    void keepWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QLabel* m_text;
    QPushButton* m_reload;
    QPushButton* m_keep;
};

} // namespace proveout
