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
    NcText before; ///< on the disk
    NcText after;
    QString afterName; ///< where the other version is, e.g. "in this window"
};

/// Of the version on the disk with that of the window.
[[nodiscard]] Comparison comparisonOf(const DiskConflict& conflict);

/// Shows where versions of files differ: one page a file, lines that only one version has are coloured and
/// marked by their sign, with a few equal lines around them. Shows no more than kMostLines of a file.
class CompareDialog final : public QDialog {
    Q_OBJECT

public:
    static constexpr int kMostLines = 4000;

    explicit CompareDialog(const std::vector<Comparison>& comparisons, QWidget* parent);

private:
    QWidget* makePage(const Comparison& comparison);
};

} // namespace proveout
