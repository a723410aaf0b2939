// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/zmap/zmap.h"

namespace proveout::test {

/// The stock after the complete program of a sample job of the repository, e.g. "core-insert". If the job
/// cannot be run, returns an empty z-map and fails an expectation.
[[nodiscard]] ZMapSnapshot sampleMap(const std::string& name);

} // namespace proveout::test
