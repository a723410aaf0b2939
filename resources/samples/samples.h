// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace proveout::samples {

/// One file of the sample jobs.
struct SampleFile {
    std::string name;
    std::string text;
};

/// All sample files, as they stand in resources/samples.
[[nodiscard]] std::vector<SampleFile> sampleFiles();

} // namespace proveout::samples
