// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QToolButton;

namespace proveout {

class NcEditor;

/// Find and replace beneath the text.
class FindBar final : public QWidget {
    Q_OBJECT

public:
    FindBar(NcEditor& editor, QWidget* parent);
    /// Shows the bar with the selected text in it.
    void open(bool withReplace);
    void find(bool forward);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void close();
    void replaceOne();
    void replaceAll();

    NcEditor& m_editor;
    QLineEdit* m_text;
    QLineEdit* m_replacement;
    QToolButton* m_previous;
    QToolButton* m_next;
    QToolButton* m_replace;
    QToolButton* m_replaceAll;
    QToolButton* m_close;
    QLabel* m_result;
};

} // namespace proveout
