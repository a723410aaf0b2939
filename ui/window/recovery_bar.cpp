// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recovery_bar.h"

#include <utility>

#include <QDateTime>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace proveout {

namespace {

constexpr int kLongestName = 40; ///< characters

QString shortName(const QString& file) {
    const QString name = QFileInfo(file).fileName();
    return name.size() <= kLongestName
               ? name
               : name.first(kLongestName / 2) + QChar(0x2026) + name.last(kLongestName / 2 - 1);
}

} // namespace

RecoveryBar::RecoveryBar(QWidget* parent) : QFrame(parent), m_title(new QLabel(this)) {
    setObjectName(QStringLiteral("recovery-bar"));
    setFrameShape(StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    m_title->setForegroundRole(QPalette::ToolTipText);
    m_title->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 8, 10, 8);
    layout->addWidget(m_title);
    hide();
}

void RecoveryBar::showRows(std::vector<RecoveryRow> rows) {
    m_rows = std::move(rows);
    fill();
    setVisible(!m_rows.empty());
}

void RecoveryBar::fill() {
    m_title->setText(tr("Proveout did not close normally. These unsaved changes can be restored:"));
    if (m_list != nullptr) {
        m_list->hide();
        m_list->deleteLater(); // it may contain the button that was clicked
    }
    m_list = new QWidget(this);
    auto* grid = new QGridLayout(m_list);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(0, 1);
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        addRow(m_rows[i], static_cast<int>(i));
    layout()->addWidget(m_list);
}

void RecoveryBar::addRow(const RecoveryRow& row, int line) {
    const QString what = row.text && row.setup ? tr("program and setup")
                         : row.text            ? tr("program")
                                               : tr("setup");
    const QString name = row.name.isEmpty() ? tr("untitled") : shortName(row.name);
    auto* label = new QLabel(
        tr("%1 (%2), %3").arg(name, what, locale().toString(row.time.toLocalTime(), QLocale::ShortFormat)),
        m_list);
    label->setTextFormat(Qt::PlainText); // the name comes from the user
    label->setForegroundRole(QPalette::ToolTipText);
    label->setToolTip(row.name);
    auto* grid = static_cast<QGridLayout*>(m_list->layout());
    grid->addWidget(label, line, 0);
    const auto add = [&](int column, const QString& text, const QString& tip,
                         void (RecoveryBar::*wanted)(const QString&)) {
        auto* button = new QPushButton(text, m_list);
        button->setToolTip(tip);
        button->setAccessibleName(text + u' ' + name);
        connect(button, &QPushButton::clicked, this, [this, wanted, key = row.key] { (this->*wanted)(key); });
        grid->addWidget(button, line, column);
    };
    add(1, tr("Restore"), tr("Open the backup as unsaved changes; the file is not changed"),
        &RecoveryBar::restoreWanted);
    add(2, tr("Compare…"), tr("Show the differences between the backup and the file"),
        &RecoveryBar::compareWanted);
    add(3, tr("Discard"), tr("Delete the backup; the file is not changed"), &RecoveryBar::discardWanted);
}

void RecoveryBar::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        fill();
}

} // namespace proveout
