// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDialog>
#include <QString>

#include "core/nc/text/nc_text.h"
#include "ui/document/job_document.h"

namespace proveout {

/// Two versions of one file. Value type.
struct Comparison {
    QString title; ///< of the file
    NcText before; ///< the version on disk
    NcText after;
    QString afterName; ///< name of the other version, e.g. "in this window"
};

/// Compares the version on disk with that of the window.
[[nodiscard]] Comparison comparisonOf(const DiskConflict& conflict);

/// Shows where versions of files differ: one page per file. Lines that only one version has are coloured and
/// marked with a sign, and shown with a few equal lines around them. Shows at most kMostLines of a file.
class CompareDialog final : public QDialog {
    Q_OBJECT

public:
    static constexpr int kMostLines = 4000;

    explicit CompareDialog(const std::vector<Comparison>& comparisons, QWidget* parent);

private:
    QWidget* makePage(const Comparison& comparison);
};

} // namespace proveout
