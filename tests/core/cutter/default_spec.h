// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <string>

#include "core/cutter/shapes.h"

namespace proveout {

/// The spec of a shape with the values that a dialog proposes for all of its keys.
inline std::string defaultSpecOf(const CutterShape& shape) {
    std::string spec;
    for (const ShapeKey& key : shape.keys)
        spec += fmt::format("{}{}={}", spec.empty() ? ':' : ',', key.key,
                            key.isText() ? key.defaultText : fmt::format("{}", key.defaultValue));
    return shape.key + spec;
}

} // namespace proveout
