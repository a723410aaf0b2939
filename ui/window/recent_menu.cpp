// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recent_menu.h"

#include <QDir>

#include "ui/document/recent_files.h"
#include "ui/files/file_flow.h"

namespace proveout {

RecentMenu::RecentMenu(FileFlow& files, QWidget* parent) : QMenu(parent), m_files(files) {
    setObjectName(QStringLiteral("recent-menu"));
    setToolTipsVisible(true);
    connect(this, &QMenu::aboutToShow, this, &RecentMenu::fill);
    connect(&files.recent(), &RecentFiles::changed, this, &RecentMenu::greyMissing);
}

void RecentMenu::fill() {
    clear();
    RecentFiles& recent = m_files.recent();
    for (const QString& file : recent.files()) {
        QAction* action = addAction(QString());
        action->setData(file);
        connect(action, &QAction::triggered, this, [this, file] { m_files.open(file); });
    }
    greyMissing();
    recent.look();
    if (!recent.files().isEmpty())
        addSeparator();
    QAction* forget = addAction(tr("Clear List"));
    forget->setEnabled(!recent.files().isEmpty());
    connect(forget, &QAction::triggered, &recent, &RecentFiles::clear);
}

void RecentMenu::greyMissing() {
    for (QAction* action : actions()) {
        const QString file = action->data().toString();
        if (file.isEmpty())
            continue;
        const bool missing = m_files.recent().isMissing(file);
        QString text = QDir::toNativeSeparators(file);
        text.replace(u'&', QStringLiteral("&&"));
        action->setText(missing ? tr("%1 (missing)").arg(text) : text);
        action->setToolTip(missing ? tr("File not found.") : QString());
        action->setEnabled(!missing);
    }
}

} // namespace proveout
