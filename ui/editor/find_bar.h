// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace proveout {

class EditorSearch;
class NcEditor;

/// Find and replace below the text, with the number of matches.
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
    void look();
    void replaceOne();
    void replaceAll();
    void report(const QString& note);
    void showTally();

    NcEditor& m_editor;
    QLineEdit* m_text;
    QLineEdit* m_replacement;
    QToolButton* m_previous;
    QToolButton* m_next;
    QToolButton* m_replace;
    QToolButton* m_replaceAll;
    QToolButton* m_close;
    QCheckBox* m_words;
    QLabel* m_result;
    EditorSearch* m_search;
    QString m_note; ///< result of the last command; shown instead of the tally
};

} // namespace proveout
