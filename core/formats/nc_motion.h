// SPDX-License-Identifier: GPL-3.0-or-later
// The answer of `interpret`: JSON Lines "nc-motion/1", one object per motion or event, lengths in mm.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "core/base/geometry.h"
#include "core/nc/program/program.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// What the first record tells about the run.
struct NcMotionMeta {
    std::string by;   ///< program and version
    std::string file; ///< name of the program
    bool blockDelete = false;
    std::optional<Vec3> start; ///< where the program was told to start; without it 0,0,0 is assumed
};

/// Writes the records `meta`, then motions, events and messages in the order of execution, then `sum`.
/// Streams: needs no memory that grows with the program. Besides the keys of the form, a motion that cannot
/// be vouched for has "unverified":true, and messages have their column "col" and kind `error`, `warning` or
/// `note`. Errors are those of the stream.
void writeNcMotion(std::ostream& out, const Program& program, const NcText& text, const NcMotionMeta& meta);

} // namespace proveout
