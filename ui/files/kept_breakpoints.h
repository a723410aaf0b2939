// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include "ui/session/session.h"

namespace proveout {

/// Stores the breakpoints of the most recent programs in the settings, by file name. Thread: UI.
class KeptBreakpoints final : public QObject {
    Q_OBJECT

public:
    /// The session must outlive this object.
    KeptBreakpoints(Session& session, QObject* parent);

    static constexpr int kMostFiles = 50;
    /// Converts a list of breakpoints to texts and back; texts that cannot be read are skipped.
    [[nodiscard]] static QStringList written(const std::vector<Breakpoint>& breakpoints);
    [[nodiscard]] static std::vector<Breakpoint> read(const QStringList& texts);

private:
    void textReplaced();
    void moveToNewName();
    void keep();

    Session& m_session;
    QString m_file; ///< the file that the session's breakpoints belong to
};

} // namespace proveout
