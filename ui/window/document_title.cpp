// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/document_title.h"

#include <QCoreApplication>
#include <QFileInfo>

#include "ui/document/file_paths.h"

namespace proveout {

QString documentName(const Session& session) {
    const QString path = toQString(session.document().text().path);
    return path.isEmpty() ? QCoreApplication::translate("DocumentTitle", "untitled")
                          : QFileInfo(path).fileName();
}

QString documentTitle(const Session& session) {
    const bool jobModified = session.document().jobModified();
    QString name = documentName(session);
    if (session.document().text().modified || !jobModified)
        name += QLatin1String("[*]"); // QWidget prints a warning if the title has no [*]
    QString job = QFileInfo(session.document().jobFile()).fileName();
    if (jobModified)
        job = (job.isEmpty() ? QCoreApplication::translate("DocumentTitle", "setup") : job) +
              QLatin1String("[*]");
    return job.isEmpty() ? QStringLiteral("%1 – Proveout").arg(name)
                         : QStringLiteral("%1 (%2) – Proveout").arg(name, job);
}

} // namespace proveout
