// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/body_profiles.h"

#include <gtest/gtest.h>
#include <string>

namespace proveout {
namespace {

/// The corners of the lower surface, radius and height.
std::vector<std::pair<double, double>> cornersOf(const std::string& keys) {
    std::vector<std::pair<double, double>> corners;
    for (const ProfilePiece& piece : holderProfile(parseCutter("flat:d=10," + keys).value())) {
        corners.emplace_back(piece.r0, piece.z0);
        corners.emplace_back(piece.r1, piece.z1);
    }
    return corners;
}

using Corners = std::vector<std::pair<double, double>>;

TEST(HolderProfile, StepsOutwardsFromTheFace) {
    EXPECT_EQ(cornersOf("so=20,holder=40x30+60x40"), (Corners{{0, 20}, {20, 20}, {20, 50}, {30, 50}}));
}

TEST(HolderProfile, HidesWhatIsNarrowerThanASegmentBelow) {
    EXPECT_EQ(cornersOf("so=20,holder=40x30+30x10+40x5"), (Corners{{0, 20}, {20, 20}}));
    EXPECT_EQ(cornersOf("so=20,holder=60-20x30+70x5"), (Corners{{0, 20}, {30, 20}, {30, 50}, {35, 50}}));
}

TEST(HolderProfile, FollowsTheVisiblePartOfACone) {
    EXPECT_EQ(cornersOf("so=20,holder=20-40x15"), (Corners{{0, 20}, {10, 20}, {10, 20}, {20, 35}}));
    // As wide as the segment below at half of its height.
    EXPECT_EQ(cornersOf("so=20,holder=30x10+20-40x10"), (Corners{{0, 20}, {15, 20}, {15, 35}, {20, 40}}));
}

TEST(HolderProfile, IsEmptyWhereTheHolderCannotTouch) {
    EXPECT_TRUE(cornersOf("so=20").empty());
    EXPECT_TRUE(cornersOf("so=20,holder=10x30").empty()) << "as wide as the cutter";
    EXPECT_FALSE(cornersOf("so=20,holder=8x30+11x5").empty());
}

TEST(ShankProfile, IsADiscAtTheEndOfTheFlutes) {
    const auto profile = shankProfile(parseCutter("flat:d=10,l=12,sd=16,sl=40").value());
    ASSERT_EQ(profile.size(), 1U);
    EXPECT_EQ(profile[0].r1, 8);
    EXPECT_EQ(profile[0].z0, 12);
    EXPECT_TRUE(shankProfile(parseCutter("flat:d=10,l=12").value()).empty()) << "not given";
    EXPECT_TRUE(shankProfile(parseCutter("flat:d=10,l=12,sd=10").value()).empty()) << "not wider";
}

} // namespace
} // namespace proveout
