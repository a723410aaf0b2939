// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/find_bar.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QProgressDialog>
#include <QStyle>
#include <QToolButton>

#include "ui/editor/editor_search.h"
#include "ui/editor/nc_editor.h"

namespace proveout {

namespace {

constexpr int kProgressSteps = 1000;

QToolButton* button(QWidget* parent, Qt::ArrowType arrow = Qt::NoArrow) {
    auto* made = new QToolButton(parent);
    made->setAutoRaise(true);
    made->setFocusPolicy(Qt::TabFocus);
    made->setArrowType(arrow);
    return made;
}

} // namespace

FindBar::FindBar(NcEditor& editor, QWidget* parent)
    : QWidget(parent), m_editor(editor), m_text(new QLineEdit(this)), m_replacement(new QLineEdit(this)),
      m_previous(button(this, Qt::UpArrow)), m_next(button(this, Qt::DownArrow)), m_replace(button(this)),
      m_replaceAll(button(this)), m_close(button(this)), m_words(new QCheckBox(this)),
      m_result(new QLabel(this)), m_search(new EditorSearch(editor, this)) {
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(m_text, 0, 0);
    layout->addWidget(m_previous, 0, 1);
    layout->addWidget(m_next, 0, 2);
    layout->addWidget(m_close, 0, 3);
    layout->addWidget(m_replacement, 1, 0);
    layout->addWidget(m_replace, 1, 1);
    layout->addWidget(m_replaceAll, 1, 2, 1, 2);
    auto* below = new QHBoxLayout;
    below->addWidget(m_words);
    below->addStretch(1);
    below->addWidget(m_result);
    layout->addLayout(below, 2, 0, 1, 4);
    m_text->setObjectName(QStringLiteral("find-text"));
    m_words->setObjectName(QStringLiteral("whole-words"));
    m_result->setObjectName(QStringLiteral("tally"));
    m_text->setClearButtonEnabled(true);
    m_close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
    connect(m_text, &QLineEdit::textChanged, this, &FindBar::look);
    connect(m_words, &QCheckBox::toggled, this, &FindBar::look);
    connect(m_search, &EditorSearch::tallied, this, &FindBar::showTally);
    connect(m_text, &QLineEdit::returnPressed, this, [this] { find(true); });
    connect(m_next, &QToolButton::clicked, this, [this] { find(true); });
    connect(m_previous, &QToolButton::clicked, this, [this] { find(false); });
    connect(m_replacement, &QLineEdit::returnPressed, this, &FindBar::replaceOne);
    connect(m_replace, &QToolButton::clicked, this, &FindBar::replaceOne);
    connect(m_replaceAll, &QToolButton::clicked, this, &FindBar::replaceAll);
    connect(m_close, &QToolButton::clicked, this, &FindBar::close);
    retranslate();
    hide();
}

void FindBar::retranslate() {
    m_text->setPlaceholderText(tr("Find"));
    m_text->setAccessibleName(tr("Find"));
    m_replacement->setPlaceholderText(tr("Replace with"));
    m_replacement->setAccessibleName(tr("Replace with"));
    m_previous->setToolTip(tr("Previous match (Shift+F3)"));
    m_previous->setAccessibleName(tr("Previous match"));
    m_next->setToolTip(tr("Next match (F3)"));
    m_next->setAccessibleName(tr("Next match"));
    m_replace->setText(tr("Replace"));
    m_replaceAll->setText(tr("All"));
    m_replaceAll->setToolTip(tr("Replace all matches"));
    m_words->setText(tr("Whole words"));
    m_words->setToolTip(tr("Find G2 in G2X10, but not in G21 or G2.1"));
    m_close->setToolTip(tr("Close (Esc)"));
    m_close->setAccessibleName(tr("Close"));
}

void FindBar::open(bool withReplace) {
    for (QWidget* widget : {static_cast<QWidget*>(m_replacement), static_cast<QWidget*>(m_replace),
                            static_cast<QWidget*>(m_replaceAll)})
        widget->setVisible(withReplace && !m_editor.isReadOnly());
    if (m_editor.hasSelectedText() && !m_editor.selectedText().contains(u'\n'))
        m_text->setText(m_editor.selectedText());
    show();
    m_text->selectAll();
    m_text->setFocus();
    m_search->setCounting(true);
    look();
}

void FindBar::look() {
    m_search->setPattern(m_text->text(), m_words->isChecked());
    report({});
}

void FindBar::find(bool forward) {
    const bool found = m_search->find(forward);
    report(found || m_text->text().isEmpty() ? QString() : tr("Not found."));
}

void FindBar::replaceOne() {
    m_search->replaceSelected(m_replacement->text());
    find(true);
}

void FindBar::replaceAll() {
    // Modal, because an edit or a save in between would meet a text of which a part is replaced.
    QProgressDialog progress(tr("Replacing…"), tr("Cancel"), 0, kProgressSteps, window());
    progress.setWindowModality(Qt::ApplicationModal);
    progress.setMinimumDuration(0);
    const int count = m_search->replaceAll(m_replacement->text(), [&progress](double done) {
        progress.setValue(static_cast<int>(done * kProgressSteps)); // handles events
        return !progress.wasCanceled();
    });
    report(tr("%n replaced.", nullptr, count));
}

void FindBar::report(const QString& note) {
    m_note = note;
    showTally();
}

void FindBar::showTally() {
    const MatchTally tally = m_search->tally();
    QString total = locale().toString(static_cast<qulonglong>(tally.total));
    if (tally.more)
        total = tr("more than %1", "matches").arg(total);
    else if (tally.counting)
        total += u'…';
    QString text = m_note;
    if (text.isEmpty() && tally.total == 0 && !tally.counting)
        text = tr("Not found.");
    else if (text.isEmpty() && tally.at > 0)
        text = tr("%1 of %2", "matches").arg(locale().toString(static_cast<qulonglong>(tally.at)), total);
    else if (text.isEmpty())
        text = tr("%1 found", "matches").arg(total);
    m_result->setText(m_text->text().isEmpty() ? QString() : text);
}

void FindBar::close() {
    hide();
    m_search->setCounting(false);
    m_editor.setFocus();
}

void FindBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        close();
    else
        QWidget::keyPressEvent(event);
}

void FindBar::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        report({});
    }
}

} // namespace proveout
