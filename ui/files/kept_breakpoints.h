// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include "ui/session/session.h"

namespace proveout {

/// Keeps the breakpoints of each program in the settings, by its file, for the newest of them. Thread: UI.
class KeptBreakpoints final : public QObject {
    Q_OBJECT

public:
    /// The session outlives this object.
    KeptBreakpoints(Session& session, QObject* parent);

    static constexpr int kMostFiles = 50;
    /// What is written for a list of breakpoints, and read from it; what cannot be read is left out.
    [[nodiscard]] static QStringList written(const std::vector<Breakpoint>& breakpoints);
    [[nodiscard]] static std::vector<Breakpoint> read(const QStringList& texts);

private:
    void textReplaced();
    void moveToNewName();
    void keep();

    Session& m_session;
    QString m_file; ///< whose breakpoints the session holds
};

} // namespace proveout
