// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

namespace proveout {

struct SampleJob {
    QString name; ///< the name that is shown
    QString file; ///< the job file
};

/// The sample jobs of the product, from the install prefix or the build tree; empty if neither has them.
[[nodiscard]] std::vector<SampleJob> sampleJobs();

/// Whether a file is one of the samples: it is opened as a template, and changes are saved elsewhere.
[[nodiscard]] bool isSample(const QString& file);

struct GuidePage {
    QString id;    ///< e.g. "setup": the panel that the page describes
    QString title; ///< its heading
    QString file;
};

/// The pages of the user guide in the sequence in which they are listed, one per file of its folder; empty if
/// they are not installed.
[[nodiscard]] std::vector<GuidePage> guidePages();

} // namespace proveout
