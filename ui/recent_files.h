// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace proveout {

/// The files opened last, newest first, kept in the settings. UI thread.
class RecentFiles {
public:
    static constexpr int kMost = 10;

    RecentFiles();
    [[nodiscard]] const QStringList& files() const { return m_files; }
    void add(const QString& file);
    void clear();

private:
    void store() const;
    QStringList m_files;
};

} // namespace proveout
