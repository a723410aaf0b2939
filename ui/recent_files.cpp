// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace proveout {

namespace {
const QString kKey = QStringLiteral("recentFiles");
}

RecentFiles::RecentFiles() : m_files(QSettings().value(kKey).toStringList().mid(0, kMost)) {}

void RecentFiles::add(const QString& file) {
    const QString path = QFileInfo(file).absoluteFilePath();
    m_files.removeAll(path);
    m_files.prepend(path);
    m_files = m_files.mid(0, kMost);
    store();
}

void RecentFiles::clear() {
    m_files.clear();
    store();
}

void RecentFiles::store() const {
    QSettings().setValue(kKey, m_files);
}

} // namespace proveout
