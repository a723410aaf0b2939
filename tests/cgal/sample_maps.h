// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/zmap/zmap.h"

namespace proveout::test {

/// The stock after the whole program of a sample job of the repository, e.g. "core-insert". An empty z-map,
/// and a failed expectation, where the job cannot be run.
[[nodiscard]] ZMapSnapshot sampleMap(const std::string& name);

} // namespace proveout::test
