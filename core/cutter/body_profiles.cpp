// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/body_profiles.h"

#include "core/cutter/shape_profiles.h"

namespace proveout {

std::vector<ProfilePiece> shankProfile(const Cutter& cutter) {
    const ToolBody& body = cutter.body();
    if (!body.shankGiven || body.shankRadius <= cutter.radius())
        return {};
    return {ringBetween(0, body.shankRadius, cutter.fluteLength())};
}

std::vector<ProfilePiece> holderProfile(const Cutter& cutter) {
    std::vector<ProfilePiece> pieces;
    double height = cutter.body().stickOut;
    double widest = 0;
    for (const HolderSegment& segment : cutter.body().holder) {
        if (segment.lowerRadius > widest) {
            pieces.push_back(ringBetween(widest, segment.lowerRadius, height));
            widest = segment.lowerRadius;
        }
        const double top = height + segment.height;
        if (segment.upperRadius > widest) {
            const double hidden =
                (widest - segment.lowerRadius) / (segment.upperRadius - segment.lowerRadius);
            pieces.push_back(sideBetween(widest, height + hidden * segment.height, segment.upperRadius, top));
            widest = segment.upperRadius;
        }
        height = top;
    }
    if (widest <= cutter.radius())
        pieces.clear();
    return pieces;
}

} // namespace proveout
