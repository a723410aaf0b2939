// SPDX-License-Identifier: GPL-3.0-or-later
// The lower surfaces of shank and holder: what the stock meets. Seen from below, a segment hides all narrower
// ones above it.
#pragma once

#include <vector>

#include "core/cutter/cutter.h"

namespace proveout {

/// The end of the shank above the flutes; empty if the shank was not given, or is not wider than the cutter.
[[nodiscard]] std::vector<ProfilePiece> shankProfile(const Cutter& cutter);
/// Heights above the tip; rising outwards, without gaps in r. Empty if the cutter has no holder, or is as
/// wide as it.
[[nodiscard]] std::vector<ProfilePiece> holderProfile(const Cutter& cutter);

} // namespace proveout
