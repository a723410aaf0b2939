// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <string>

#include "core/cutter/shapes.h"

namespace proveout {

/// The spec of a shape with all its own keys at what a dialog proposes.
inline std::string standardSpecOf(const CutterShape& shape) {
    std::string spec;
    for (const ShapeKey& key : shape.keys)
        spec += fmt::format("{}{}={}", spec.empty() ? ':' : ',', key.key,
                            key.isText() ? key.standardText : fmt::format("{}", key.standard));
    return shape.key + spec;
}

} // namespace proveout
