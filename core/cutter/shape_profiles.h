// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the profile of each shape from the values of its keys, in the order of its row in shapes.cpp. Pure;
// any thread. Errors: values that fit no shape together.
#pragma once

#include "core/cutter/shapes.h"

namespace proveout {

// mill_profiles.cpp
[[nodiscard]] Result<CutterProfile> flatProfile(const ShapeValues& values);
[[nodiscard]] Result<CutterProfile> ballProfile(const ShapeValues& values);
[[nodiscard]] Result<CutterProfile> bullProfile(const ShapeValues& values);
[[nodiscard]] Result<CutterProfile> taperProfile(const ShapeValues& values);
[[nodiscard]] Result<CutterProfile> taperBallProfile(const ShapeValues& values);
[[nodiscard]] Result<CutterProfile> faceProfile(const ShapeValues& values);

// hole_profiles.cpp
[[nodiscard]] Result<CutterProfile> coneProfile(const ShapeValues& values);
[[nodiscard]] Result<CutterProfile> drillProfile(const ShapeValues& values);
[[nodiscard]] Result<CutterProfile> centreProfile(const ShapeValues& values);
[[nodiscard]] Result<CutterProfile> reamerProfile(const ShapeValues& values);
/// Of taps and thread mills: the cylinder that encloses their teeth.
[[nodiscard]] Result<CutterProfile> threadProfile(const ShapeValues& values);

// necked_profiles.cpp
[[nodiscard]] Result<CutterProfile> lollipopProfile(const ShapeValues& values);
[[nodiscard]] Result<CutterProfile> slotProfile(const ShapeValues& values);
[[nodiscard]] Result<CutterProfile> dovetailProfile(const ShapeValues& values);

// form_profile.cpp
[[nodiscard]] Result<CutterProfile> formProfile(const ShapeValues& values);

// profile_pieces.cpp: the pieces that profiles are made of

/// A ring between two radii at one height; a disc from 0.
[[nodiscard]] ProfilePiece ringBetween(double r0, double r1, double z = 0);
/// From (r0, z0) to (r1, z1).
[[nodiscard]] ProfilePiece sideBetween(double r0, double z0, double r1, double z1);
/// A quarter circle that leaves the tip plane at `from`.
[[nodiscard]] ProfilePiece cornerFrom(double from, double cornerRadius);
/// The error for a corner radius that is too large for the rest of the shape.
[[nodiscard]] tl::unexpected<Diagnostics> cornerTooLarge(double corner, double largest);

} // namespace proveout
