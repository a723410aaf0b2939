// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/cutter/cutter.h"

namespace proveout {

/// From the tip of a tool to the face of the spindle, mm: stick-out and holder. Nothing without a holder, or
/// if there is no cutter (null).
[[nodiscard]] inline std::optional<double> gaugeLength(const Cutter* cutter) {
    if (cutter == nullptr || cutter->body().holder.empty())
        return {};
    double length = cutter->body().stickOut;
    for (const HolderSegment& segment : cutter->body().holder)
        length += segment.height;
    return length;
}

} // namespace proveout
