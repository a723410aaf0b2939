// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/kernels/straight_pass.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

/// Distances are computed from numbers as large as the cutter and a tile; a point on the rim must count as
/// under the cutter whichever way each of them is rounded.
constexpr double kRimSlack = 2e-7;
/// A bound is a sum of several products, each as large as a length or a height times a slope.
constexpr double kBoundSlack = 2e-6;

constexpr double kLargest = 200;   ///< mm: largest radius
constexpr double kNarrowTile = 24; ///< mm: from a tile's middle to a corner; wider tiles only below large
                                   ///< cutters
constexpr double kSteepest = 16;   ///< mm per mm

/// A motion that continues another still cuts what is under its start as far behind it as this times the
/// size: beside the rim a root makes that of the rounding of a distance, and a point must not be left out by
/// both.
constexpr double kOverlap = 1e-3;

float toFloat(double value) {
    return static_cast<float>(value);
}

bool isBall(const ConvexProfile& profile) {
    return profile.flatTo == 0 && profile.centreR == 0;
}

/// The square of how far ahead a cone is, divided by the square of the distance across.
double lineLead(double fall, double rise) {
    return fall < rise ? fall * fall / ((rise - fall) * (rise + fall)) : -1;
}

/// Roughly how far ahead of a point the cutter is when it is lowest over it: exact for balls, and at the
/// path's line for others.
void setAhead(TilePass& form, const ConvexProfile& profile, double fall) {
    const double sine = fall / std::sqrt(1 + fall * fall);
    double radius = profile.rim;
    if (profile.side == ConvexProfile::Side::arc)
        radius = isBall(profile) ? profile.radius : profile.centreR + profile.radius * sine;
    else if (profile.side == ConvexProfile::Side::line && fall < profile.slope)
        radius = profile.flatTo;
    form.aheadRate = isBall(profile) ? toFloat(sine) : 1.0F;
    if (form.slope > 0)
        form.aheadRate = -form.aheadRate;
    form.aheadRadius2 = toFloat(radius * radius);
}

} // namespace

void setHollow(TilePass& form, const HollowProfile& hollow) {
    form.form = TilePass::Form::hollow;
    form.hollowRing = toFloat(hollow.centreR);
    form.hollowCentre = toFloat(hollow.centreZ - hollow.below.reference());
    form.hollowRadius2 = toFloat(hollow.radius * hollow.radius);
    form.lead = 0;
}

TilePass StraightPass::formOf(const ConvexProfile& profile, const StraightPath& path) {
    const double fall = std::abs(path.slope);
    TilePass form;
    form.level = fall == 0 || path.length == 0;
    form.slope = form.level ? 0.0F : toFloat(path.slope);
    form.flatTo = toFloat(profile.flatTo);
    form.rise = toFloat(profile.slope);
    form.ring = toFloat(profile.centreR);
    form.radius = toFloat(profile.radius);
    switch (profile.side) {
    case ConvexProfile::Side::none:
        form.form = TilePass::Form::flat;
        break;
    case ConvexProfile::Side::line:
        form.form = TilePass::Form::line;
        form.lead = toFloat(lineLead(fall, profile.slope));
        break;
    case ConvexProfile::Side::arc:
        form.form = isBall(profile) ? TilePass::Form::ball : TilePass::Form::corner;
        form.lead = toFloat(fall / std::sqrt(1 + fall * fall));
        break;
    }
    if (!form.level)
        setAhead(form, profile, fall);
    const bool arc = profile.side == ConvexProfile::Side::arc;
    form.inner = toFloat(arc ? profile.centreR : profile.flatTo);
    form.outer = arc ? form.inner : toFloat(profile.rim);
    return form;
}

bool StraightPass::suffices(const ConvexProfile& profile, const StraightPath& path,
                            const TileSpacing& spacing) {
    return profile.rim <= kLargest && spacing.tileReach <= std::max(kNarrowTile, 2 * profile.rim) &&
           std::abs(path.slope) <= kSteepest;
}

StraightPass::StraightPass(const ConvexProfile& profile, const StraightPath& path)
    : m_path(path), m_rim(profile.rim), m_reference(profile.reference()), m_form(formOf(profile, path)) {
    m_path.continues = path.continues && path.length > 0;
}

StraightPass::StraightPass(std::shared_ptr<const LevelProfile> whole, const StraightPath& path)
    : StraightPass(whole->below, path) {
    m_form.form = TilePass::Form::whole;
    m_form.whole = whole.get();
    m_whole = std::move(whole);
}

StraightPass::StraightPass(const HollowProfile& hollow, const StraightPath& path)
    : StraightPass(hollow.below, path) {
    setHollow(m_form, hollow);
    m_path.continues = false;
}

StraightPass StraightPass::atLowerEnd(const HollowProfile& hollow, const StraightPath& path) {
    StraightPass pass(hollow, path);
    pass.m_form.lead = -1;
    return pass;
}

bool StraightPass::fitLeads() {
    TilePass pass = m_form;
    pass.rim2 = toFloat(m_rim * m_rim);
    m_bands = leadBands(pass);
    m_form.bands = m_bands.get();
    return m_bands != nullptr;
}

double StraightPass::alongAt(double x, double y) const {
    return (x - m_path.from.x) * m_path.along.x + (y - m_path.from.y) * m_path.along.y;
}

double StraightPass::overlap(const TileSpacing& spacing) const {
    return kOverlap * (m_rim + spacing.tileReach);
}

/// On a path that falls: that of an arc is largest on the path's line.
double StraightPass::largestLead() const {
    if (!(m_form.slope < 0))
        return 0;
    const bool arc = m_form.form == TilePass::Form::ball || m_form.form == TilePass::Form::corner;
    const double lead = arc ? m_form.ring + m_form.radius * m_form.lead : m_rim;
    return std::min(lead, m_rim);
}

bool StraightPass::reachesBeyondStart(double x, double y, const TileSpacing& spacing) const {
    return !m_path.continues || alongAt(x, y) + spacing.tileReach + largestLead() + 2 * overlap(spacing) > 0;
}

TilePass StraightPass::overTile(double x, double y, const TileSpacing& spacing) const {
    const double dx = x - m_path.from.x;
    const double dy = y - m_path.from.y;
    const double along = alongAt(x, y);
    const double size = m_rim + spacing.tileReach;
    // Points beyond the cutter's reach need not be distinguished.
    const double far = size + 1;
    const double origin = std::clamp(along, 0.0, m_path.length);
    const double z = m_path.z + m_path.slope * origin + m_reference;
    const double padded = m_rim + kRimSlack * size;
    const double reach = padded + spacing.blockReach * (1 + 1e-5);
    TilePass pass = m_form;
    pass.along = toFloat(along - origin);
    pass.across = toFloat(dy * m_path.along.x - dx * m_path.along.y);
    pass.alongX = toFloat(spacing.hx * m_path.along.x);
    pass.alongY = toFloat(spacing.hy * m_path.along.y);
    pass.acrossX = toFloat(-spacing.hx * m_path.along.y);
    pass.acrossY = toFloat(spacing.hy * m_path.along.x);
    pass.begin = toFloat(-std::min(origin, far));
    pass.end = toFloat(std::min(m_path.length - origin, far));
    if (m_path.continues && origin <= far) {
        pass.from = toFloat(-origin - overlap(spacing));
        pass.blocksFrom = toFloat(-origin - 2 * overlap(spacing) - largestLead() - spacing.blockReach);
    }
    pass.z = toFloat(z);
    pass.rim2 = toFloat(padded * padded);
    pass.reach2 = toFloat(reach * reach);
    pass.slack = toFloat(kBoundSlack * (size * (1 + std::abs(m_path.slope)) + std::abs(z)));
    return pass;
}

} // namespace proveout
