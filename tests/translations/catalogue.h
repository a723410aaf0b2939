// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>
#include <QStringList>

namespace proveout {

/// One message of a .ts file.
struct CatalogueMessage {
    QString context;
    QString source;
    QString comment;
    QString state; ///< "", "unfinished", "vanished" or "obsolete"
    bool numerus = false;
    QStringList translations; ///< one, or one per plural form

    /// Context, source and comment in one line.
    [[nodiscard]] QString name() const;
};

/// Reads a .ts file; empty if it is not valid.
[[nodiscard]] std::vector<CatalogueMessage> readCatalogue(const QString& file);

/// The placeholders that a translation must keep from its source: `%1`, `%L1`, `%n` and `{}` (`{2}` counts as
/// `{}`), sorted.
[[nodiscard]] QStringList placeholders(const QString& text);

} // namespace proveout
