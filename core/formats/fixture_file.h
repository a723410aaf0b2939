// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cutting/fixtures/fixture.h"

namespace proveout {

/// Reads the STL file of a fixture. There is always a surface afterwards: if the file cannot be used, one
/// without facets, whose findings say why. Takes as long as reading the file. Any thread.
void readFixtureFile(FixtureMesh& mesh);

} // namespace proveout
