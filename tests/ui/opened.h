// SPDX-License-Identifier: GPL-3.0-or-later
// Opening and reading again, for tests that go on when it is through.
#pragma once

#include <QString>
#include <QTest>

#include "ui/session/session.h"

namespace proveout {

inline constexpr int kOpeningPatience = 30'000; ///< ms

/// Waits until nothing is being read for the document.
inline bool openingIsOver(const Session& session) {
    return QTest::qWaitFor([&] { return !session.document().isOpening(); }, kOpeningPatience);
}

/// Whether the file was opened.
inline bool opened(Session& session, const QString& file) {
    bool done = false;
    const auto connection =
        QObject::connect(&session.document(), &DocumentHub::opened, &session, [&done] { done = true; });
    session.document().openFile(file);
    const bool over = openingIsOver(session);
    QObject::disconnect(connection);
    return over && done;
}

} // namespace proveout
