// SPDX-License-Identifier: GPL-3.0-or-later
// Opens and reloads files for tests that continue when the reading has finished.
#pragma once

#include <QString>
#include <QTest>

#include "ui/session/session.h"

namespace proveout {

inline constexpr int kOpeningPatience = 30'000; ///< ms

/// Waits until no reading for the document is in progress.
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
