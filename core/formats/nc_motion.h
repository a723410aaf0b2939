// SPDX-License-Identifier: GPL-3.0-or-later
// The output of `interpret`: JSON Lines "nc-motion/1", one object per motion or event, lengths in mm.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "core/base/geometry.h"
#include "core/nc/program/program.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// The values of the first record, which describes the run.
struct NcMotionMeta {
    std::string by;   ///< name and version of the writing software
    std::string file; ///< name of the program
    bool blockDelete = false;
    std::optional<Vec3> start; ///< the given start position of the program; 0,0,0 is assumed if it is missing
};

/// Writes the records `meta`, then motions, events and messages in the order of execution, then `sum`.
/// Streams: its memory does not grow with the program. Besides the keys of the format, an unverified motion
/// has "unverified":true, and messages have their column "col" and kind `error`, `warning` or `note`. Errors
/// are those of the stream.
void writeNcMotion(std::ostream& out, const Program& program, const NcText& text, const NcMotionMeta& meta);

} // namespace proveout
