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

} // namespace proveout
