// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/rows/straight_row.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/cutting/profiles/lanes.h"
#include "core/cutting/profiles/profile_forms.h"
#include "core/cutting/profiles/vector_clones.h"

namespace proveout {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One row in the coordinates of the path: along it and across it, both linear in the column.
struct Line {
    double along;
    double alongStep;
    double across;
    double acrossStep;
    double length;
    double z;
    double slope;
    double rim2;

    Line(const ConvexProfile& profile, const StraightPath& path, const RowPoints& row)
        : length(path.length), z(path.z), slope(path.slope), rim2(profile.rim * profile.rim) {
        const double x = row.x - path.from.x;
        const double y = row.y - path.from.y;
        along = x * path.along.x + y * path.along.y;
        alongStep = row.step * path.along.x;
        across = y * path.along.x - x * path.along.y;
        acrossStep = -row.step * path.along.y;
    }
};

/// How far ahead the cutter is where it is lowest, from the squared distance across; one type per form.
struct NoLead {
    [[nodiscard]] double operator()(double) const { return 0; }
};

/// At the rim: for a flat, or a cone no steeper than the path.
struct RimLead {
    double rim2;
    [[nodiscard]] double operator()(double across2) const { return rootOf(rim2 - across2); }
};

struct ConeLead {
    double rate2;
    double flatTo2;
    double rim2;
    [[nodiscard]] double operator()(double across2) const {
        return lesser(greater(rootOf(rate2 * across2), rootOf(flatTo2 - across2)), rootOf(rim2 - across2));
    }
};

struct BallLead {
    double rate;
    double radius2;
    double rim2;
    [[nodiscard]] double operator()(double across2) const {
        return lesser(rate * rootOf(radius2 - across2), rootOf(rim2 - across2));
    }
};

template<class Form, class Lead>
[[gnu::always_inline]] inline void lowerPoints(const Form& form, const Lead& lead, const Line& line,
                                               Columns columns, float* out) {
    const double sign = line.slope < 0 ? 1.0 : -1.0;
    for (int k = columns.begin; k < columns.end; ++k) {
        const double along = line.along + line.alongStep * k;
        const double across = line.across + line.acrossStep * k;
        const double across2 = across * across;
        const double nearest = lesser(greater(along, 0.0), line.length);
        const double off = along - nearest;
        const bool under = off * off + across2 <= line.rim2;
        const double place = lesser(greater(along + sign * lead(across2), 0.0), line.length);
        const double away = along - place;
        const double z = line.z + line.slope * place + form.height(away * away + across2);
        const auto cut = static_cast<float>(under ? z : kInfinity);
        out[k] = cut < out[k] ? cut : out[k];
    }
}

PROVEOUT_VECTOR_CLONES void flatLevel(const FlatForm& form, const Line& line, Columns columns, float* out) {
    lowerPoints(form, NoLead{}, line, columns, out);
}
PROVEOUT_VECTOR_CLONES void lineLevel(const LineForm& form, const Line& line, Columns columns, float* out) {
    lowerPoints(form, NoLead{}, line, columns, out);
}
PROVEOUT_VECTOR_CLONES void ballLevel(const BallForm& form, const Line& line, Columns columns, float* out) {
    lowerPoints(form, NoLead{}, line, columns, out);
}
PROVEOUT_VECTOR_CLONES void cornerLevel(const CornerForm& form, const Line& line, Columns columns,
                                        float* out) {
    lowerPoints(form, NoLead{}, line, columns, out);
}
PROVEOUT_VECTOR_CLONES void flatSloped(const FlatForm& form, const Line& line, Columns columns, float* out) {
    lowerPoints(form, RimLead{line.rim2}, line, columns, out);
}
PROVEOUT_VECTOR_CLONES void lineSteep(const LineForm& form, const Line& line, Columns columns, float* out) {
    lowerPoints(form, RimLead{line.rim2}, line, columns, out);
}
PROVEOUT_VECTOR_CLONES void lineSloped(const LineForm& form, const ConeLead& lead, const Line& line,
                                       Columns columns, float* out) {
    lowerPoints(form, lead, line, columns, out);
}
PROVEOUT_VECTOR_CLONES void ballSloped(const BallForm& form, const BallLead& lead, const Line& line,
                                       Columns columns, float* out) {
    lowerPoints(form, lead, line, columns, out);
}

PROVEOUT_VECTOR_CLONES void cornerSloped(const CornerForm& form, double corner, const Line& line,
                                         Columns columns, float* out) {
    const Lanes fall = allLanes(std::fabs(line.slope));
    const double sign = line.slope < 0 ? 1.0 : -1.0;
    for (int k0 = columns.begin; k0 < columns.end; k0 += kLanes) {
        const Lanes along = ramp(line.along + line.alongStep * k0, line.alongStep);
        const Lanes across = ramp(line.across + line.acrossStep * k0, line.acrossStep);
        const Lanes across2 = lesser(across * across, allLanes(line.rim2));
        const Lanes nearest = lesser(greater(along, Lanes{}), allLanes(line.length));
        const Lanes off = along - nearest;
        const LaneMask under = off * off + across * across <= line.rim2;
        if (!any(under))
            continue;
        const Lanes radii = touchingRadii(form.centreR, corner, fall, across2);
        const Lanes lead =
            lesser(greater(rootOf(radii * radii - across2), rootOf(form.flatTo * form.flatTo - across2)),
                   rootOf(line.rim2 - across2));
        const Lanes place = lesser(greater(along + sign * lead, Lanes{}), allLanes(line.length));
        const Lanes away = along - place;
        const Lanes z = line.z + line.slope * place + form.height(away * away + across2);
        storeLower(under ? z : allLanes(kInfinity), columns.end - k0, out + k0);
    }
}

} // namespace

void straightRow(const ConvexProfile& profile, const StraightPath& path, const RowPoints& row,
                 Columns columns, float* out) {
    const Line line(profile, path, row);
    const double fall = std::abs(path.slope);
    const bool level = fall == 0 || path.length == 0;
    switch (profile.side) {
    case ConvexProfile::Side::none: {
        const FlatForm form(profile);
        return level ? flatLevel(form, line, columns, out) : flatSloped(form, line, columns, out);
    }
    case ConvexProfile::Side::line: {
        const LineForm form(profile);
        if (level)
            return lineLevel(form, line, columns, out);
        if (fall >= profile.slope)
            return lineSteep(form, line, columns, out);
        const double rate2 = fall * fall / ((profile.slope - fall) * (profile.slope + fall));
        return lineSloped(form, {rate2, profile.flatTo * profile.flatTo, line.rim2}, line, columns, out);
    }
    case ConvexProfile::Side::arc:
        break;
    }
    if (profile.flatTo == 0 && profile.centreR == 0) {
        const BallForm form(profile);
        if (level)
            return ballLevel(form, line, columns, out);
        return ballSloped(form, {fall / std::sqrt(1 + fall * fall), form.radius2, line.rim2}, line, columns,
                          out);
    }
    const CornerForm form(profile);
    if (level)
        return cornerLevel(form, line, columns, out);
    return cornerSloped(form, profile.radius, line, columns, out);
}

} // namespace proveout
