// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

namespace proveout {

struct SampleJob {
    QString name; ///< for people
    QString file; ///< the job file
};

/// The jobs that come with the product, from the install prefix or the build tree; empty where neither has
/// them.
[[nodiscard]] std::vector<SampleJob> sampleJobs();

/// Whether a file lies among the samples: it is opened as a pattern, and changes are saved elsewhere.
[[nodiscard]] bool isSample(const QString& file);

struct GuidePage {
    QString id;    ///< "setup": of the panel that it is about
    QString title; ///< its heading
    QString file;
};

/// The pages of the user guide in the order in which they are listed, each file of its folder one page; empty
/// where they are not installed.
[[nodiscard]] std::vector<GuidePage> guidePages();

} // namespace proveout
