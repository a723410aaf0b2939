// SPDX-License-Identifier: GPL-3.0-or-later
// The forms of a convex profile as the inner loops need them: a height from the squared distance, without
// branches. Each form is a type, so that a loop is compiled for it.
#pragma once

#include <cmath>

#include "core/cutting/profiles/convex_profile.h"
#include "core/cutting/profiles/lanes.h"

namespace proveout {

/// Minimum and maximum by value: std::min returns references, which keep loops from becoming vector code.
[[nodiscard]] inline double lesser(double a, double b) {
    return a < b ? a : b;
}
[[nodiscard]] inline double greater(double a, double b) {
    return a > b ? a : b;
}
/// Square root of a value that may be below zero through rounding.
[[nodiscard]] inline double rootOf(double value) {
    return std::sqrt(greater(0.0, value));
}

struct FlatForm {
    double z0;

    explicit FlatForm(const ConvexProfile& profile) : z0(profile.z0) {}
    [[nodiscard]] double height(double) const { return z0; }
    PROVEOUT_LANES Lanes height(const Lanes&) const { return allLanes(z0); }
};

struct LineForm {
    double z0;
    double flatTo;
    double slope;

    explicit LineForm(const ConvexProfile& profile)
        : z0(profile.z0), flatTo(profile.flatTo), slope(profile.slope) {}
    [[nodiscard]] double height(double distance2) const {
        return z0 + slope * greater(0.0, std::sqrt(distance2) - flatTo);
    }
};

struct BallForm {
    double centreZ;
    double radius2;

    explicit BallForm(const ConvexProfile& profile)
        : centreZ(profile.centreZ), radius2(profile.radius * profile.radius) {}
    [[nodiscard]] double height(double distance2) const { return centreZ - rootOf(radius2 - distance2); }
    PROVEOUT_LANES Lanes height(const Lanes& distance2) const {
        return centreZ - rootOf(radius2 - distance2);
    }
};

struct CornerForm {
    double flatTo;
    double centreR;
    double centreZ;
    double radius2;

    explicit CornerForm(const ConvexProfile& profile)
        : flatTo(profile.flatTo), centreR(profile.centreR), centreZ(profile.centreZ),
          radius2(profile.radius * profile.radius) {}
    [[nodiscard]] double height(double distance2) const {
        const double out = greater(flatTo, std::sqrt(distance2)) - centreR;
        return centreZ - rootOf(radius2 - out * out);
    }
    PROVEOUT_LANES Lanes height(const Lanes& distance2) const {
        const Lanes out = greater(allLanes(flatTo), sqrtOf(distance2)) - centreR;
        return centreZ - rootOf(radius2 - out * out);
    }
};

/// Calls `work` with the form of the profile.
template<class Work>
void withForm(const ConvexProfile& profile, Work&& work) {
    switch (profile.side) {
    case ConvexProfile::Side::none:
        return work(FlatForm(profile));
    case ConvexProfile::Side::line:
        return work(LineForm(profile));
    case ConvexProfile::Side::arc:
        break;
    }
    if (profile.flatTo == 0 && profile.centreR == 0)
        return work(BallForm(profile));
    return work(CornerForm(profile));
}

} // namespace proveout
