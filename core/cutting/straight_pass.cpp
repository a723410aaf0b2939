// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/straight_pass.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

/// Distances are computed from numbers as large as the cutter and a block; a point on the rim must count as
/// under the cutter whichever way each of them rounds.
constexpr double kRimSlack = 2e-7;
/// Heights near the rim of a ball fall steeply, so that their slack is larger than that of places.
constexpr double kHeightSlack = 2e-5;

constexpr double kLargest = 200;   ///< mm: radius
constexpr double kNarrowBlock = 4; ///< mm: from corner to corner; wider ones only below a cutter as large
constexpr double kSteepest = 16;   ///< mm per mm

float toFloat(double value) {
    return static_cast<float>(value);
}

double extentOf(double hx, double hy) {
    return std::hypot(hx, hy) * (Tile::kBlockSize - 1);
}

bool isBall(const ConvexProfile& profile) {
    return profile.flatTo == 0 && profile.centreR == 0;
}

/// The square of how far ahead a cone stands, per square of the distance across.
double lineLead(double fall, double rise) {
    return fall < rise ? fall * fall / ((rise - fall) * (rise + fall)) : -1;
}

BlockPass formOf(const ConvexProfile& profile, const StraightPath& path) {
    const double fall = std::abs(path.slope);
    BlockPass form;
    form.level = fall == 0 || path.length == 0;
    form.slope = form.level ? 0.0F : toFloat(path.slope);
    form.flatTo = toFloat(profile.flatTo);
    form.rise = toFloat(profile.slope);
    form.ring = toFloat(profile.centreR);
    form.radius = toFloat(profile.radius);
    switch (profile.side) {
    case ConvexProfile::Side::none:
        form.form = BlockPass::Form::flat;
        break;
    case ConvexProfile::Side::line:
        form.form = BlockPass::Form::line;
        form.lead = toFloat(lineLead(fall, profile.slope));
        break;
    case ConvexProfile::Side::arc:
        form.form = isBall(profile) ? BlockPass::Form::ball : BlockPass::Form::corner;
        form.lead = toFloat(fall / std::sqrt(1 + fall * fall));
        break;
    }
    return form;
}

/// Every radius larger by `margin`; a ball becomes a corner round a flat.
ConvexProfile dilatedOver(const ConvexProfile& profile, double margin) {
    ConvexProfile wider = profile;
    wider.rim += margin;
    wider.flatTo += margin;
    wider.centreR += margin;
    return wider;
}

} // namespace

bool StraightPass::suffices(const ConvexProfile& profile, const StraightPath& path, double hx, double hy) {
    return profile.rim <= kLargest && extentOf(hx, hy) <= std::max(kNarrowBlock, profile.rim) &&
           std::abs(path.slope) <= kSteepest;
}

StraightPass::StraightPass(const ConvexProfile& profile, const StraightPath& path, double hx, double hy)
    : m_path(path), m_hx(hx), m_hy(hy), m_rim(profile.rim), m_extent(extentOf(hx, hy)),
      m_reference(profile.side == ConvexProfile::Side::arc ? profile.centreZ : profile.z0),
      m_form(formOf(profile, path)) {
    const double wider = m_extent / 2 * (1 + 1e-6);
    m_dilated = formOf(dilatedOver(profile, wider), path);
    if (!m_form.level || m_form.form != BlockPass::Form::flat)
        m_slack = toFloat(kHeightSlack * (1 + m_rim + m_extent));
}

BlockPass StraightPass::seenFrom(const BlockPass& form, double rim, double extent, double x, double y) const {
    const double dx = x - m_path.from.x;
    const double dy = y - m_path.from.y;
    const double along = dx * m_path.along.x + dy * m_path.along.y;
    // What lies farther than the cutter reaches, from any point, need not be told apart.
    const double reach = rim + extent + 1;
    // Numbers are told from the place on the path that is nearest to the first point.
    const double origin = std::clamp(along, 0.0, m_path.length);
    BlockPass pass = form;
    pass.along = toFloat(along - origin);
    pass.across = toFloat(dy * m_path.along.x - dx * m_path.along.y);
    pass.begin = toFloat(-std::min(origin, reach));
    pass.end = toFloat(std::min(m_path.length - origin, reach));
    pass.z = toFloat(m_path.z + m_path.slope * origin + m_reference);
    const double padded = rim + kRimSlack * (rim + extent);
    pass.rim2 = toFloat(padded * padded);
    return pass;
}

BlockPass StraightPass::overBlock(double x, double y) const {
    BlockPass pass = seenFrom(m_form, m_rim, m_extent, x, y);
    pass.alongX = toFloat(m_hx * m_path.along.x);
    pass.alongY = toFloat(m_hy * m_path.along.y);
    pass.acrossX = toFloat(-m_hx * m_path.along.y);
    pass.acrossY = toFloat(m_hy * m_path.along.x);
    return pass;
}

BlockPass StraightPass::overTile(double x, double y) const {
    constexpr double kMiddle = (Tile::kBlockSize - 1) / 2.0;
    const double wider = m_extent / 2;
    BlockPass pass =
        seenFrom(m_dilated, m_rim + wider, m_extent * Tile::kBlocks, x + kMiddle * m_hx, y + kMiddle * m_hy);
    pass.alongX = toFloat(Tile::kBlockSize * m_hx * m_path.along.x);
    pass.alongY = toFloat(Tile::kBlockSize * m_hy * m_path.along.y);
    pass.acrossX = toFloat(-Tile::kBlockSize * m_hx * m_path.along.y);
    pass.acrossY = toFloat(Tile::kBlockSize * m_hy * m_path.along.x);
    return pass;
}

} // namespace proveout
