// SPDX-License-Identifier: GPL-3.0-or-later
// The moments of contacts, against moments and heights of the tool one by one.
#include "core/verification/check/found_contact.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "core/verification/check/check.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

constexpr double kStickOut = 15;
constexpr double kHolder = 10; ///< radius
const std::string kHead = "G21 G90 G17\nT1 M6\nS1000 M3\nG0 X20 Y15 Z20\n";

/// A ball-end mill of 4 mm with a holder.
Setup setupWith(const Fixtures& fixtures) {
    Setup setup = *smallSetup();
    setup.tools.set(1, parseCutter("ball:d=4,l=10,sd=4,so=15,holder=20x20").value());
    setup.fixtures = fixtures;
    return setup;
}

double radiusAt(double z) {
    if (z >= kStickOut)
        return kHolder;
    return z < 2 ? std::sqrt(z * (4 - z)) : 2;
}

/// By how much a box is higher than the lowest point of the tool above it.
double depthIn(const FixtureBox& box, const Vec3& tip) {
    const double dx = std::max({box.x - tip.x, 0.0, tip.x - box.x - box.w});
    const double dy = std::max({box.y - tip.y, 0.0, tip.y - box.y - box.d});
    double deepest = -1e9;
    for (int k = 0; k <= 3000; ++k) {
        const double z = 0.01 * k;
        if (radiusAt(z) >= std::hypot(dx, dy))
            deepest = std::max(deepest, box.z + box.h - tip.z - z);
    }
    return deepest;
}

struct Found {
    std::shared_ptr<const Program> program;
    CheckReport report;
    Setup setup;

    Found(const std::string& text, const Setup& with) : program(programOf(text)), setup(with) {
        const auto checked = check({.program = program, .setup = std::make_shared<const Setup>(with)}, {},
                                   std::numeric_limits<std::uint64_t>::max());
        if (checked)
            report = **checked;
    }
    [[nodiscard]] const CheckFinding* finding(std::string_view id) const {
        const auto found =
            std::ranges::find_if(report.findings, [&](const auto& one) { return one.diagnostic.id == id; });
        return found == report.findings.end() ? nullptr : &*found;
    }
    [[nodiscard]] std::optional<FoundContact> contact(std::string_view id) const {
        const CheckFinding* one = finding(id);
        return one == nullptr ? std::nullopt : contactOf(*one, *program, setup);
    }
};

TEST(FoundContact, OfAFixtureIsItsDeepestMoment) {
    const FixtureBox clamp{25, 10, -10, 10, 8, 13};
    // The second rapid is deeper: it passes the corner of the clamp on a slope.
    const Found found(kHead + "G0 X0 Y0 Z2.9\nG0 X26 Y9\nG0 Z20\nX20 Y0 Z10\nX40 Y22 Z-1\nZ20\nM30\n",
                      setupWith({{"clamp", clamp}, {"far", FixtureCylinder{500, 500, 0, 10, 10}}}));
    const auto contact = found.contact("fixture-collision");
    ASSERT_TRUE(contact.has_value());
    double deepest = 0;
    std::size_t worst = 0;
    for (std::size_t block = 0; block < found.program->blockCount(); ++block) {
        const auto motions = found.program->blockMotions(block);
        for (std::size_t index = motions.first; index < motions.last; ++index)
            for (int k = 0; k <= 500; ++k) {
                const double depth = depthIn(clamp, pointAt(found.program->motion(index), k / 500.0));
                if (found.program->motion(index).known() && depth > deepest) {
                    deepest = depth;
                    worst = block;
                }
            }
    }
    EXPECT_GT(deepest, 1);
    EXPECT_EQ(contact->block, worst);
    EXPECT_EQ(contact->fixture, "clamp");
    EXPECT_NEAR(depthIn(clamp, contact->tip), deepest, 0.05);
    EXPECT_NEAR(found.finding("fixture-collision")->value, deepest, 0.05);
    EXPECT_EQ(contact->place.z, 3) << "the top of the clamp";
    EXPECT_GE(contact->place.x, 25);
    EXPECT_LE(contact->place.x, 35);
    EXPECT_GE(contact->place.y, 10);
    EXPECT_LE(contact->place.y, 18);
}

TEST(FoundContact, OfAFixtureNamesThePartOfTheTool) {
    // The holder, whose face is 15 mm above the tip, meets a post of 18 mm that the cutter passes.
    const Fixtures post{{"post", FixtureBox{30, 10, -10, 5, 5, 28}}};
    const auto holder =
        Found(kHead + "G0 X24 Y12 Z1\nZ20\nM30\n", setupWith(post)).contact("fixture-collision");
    ASSERT_TRUE(holder.has_value());
    EXPECT_EQ(holder->part, ToolPart::holder);
    EXPECT_EQ(holder->size, kHolder);
    EXPECT_NEAR(holder->tip.z, 1, 1e-6);
    const auto flutes = Found(kHead + "G0 X32 Z10\nZ20\nM30\n", setupWith(post)).contact("fixture-collision");
    ASSERT_TRUE(flutes.has_value());
    EXPECT_EQ(flutes->part, ToolPart::flutes);
    EXPECT_NEAR(flutes->tip.z, 10, 1e-6);
    // Nearer than 1 mm: the tool passes at 0.5 mm.
    const auto near = Found(kHead + "G0 X27.5 Y-50\nZ1\nG0 Y40\nZ20\nM30\n",
                            setupWith({{"bar", FixtureBox{30, 10, -10, 5, 5, 12}}}))
                          .contact("fixture-near");
    ASSERT_TRUE(near.has_value());
    EXPECT_EQ(near->part, ToolPart::flutes);
    EXPECT_NEAR(near->tip.x, 27.5, 1e-6);
    EXPECT_GE(near->tip.y, 8);
    EXPECT_LE(near->tip.y, 17);
}

TEST(FoundContact, OfTheHolderIsTheMomentAtItsPlace) {
    // A trench as deep as 8 mm does not reach the face of the holder, but one of 17 mm would: the stock is 10
    // mm thick, so the tool is shorter.
    proveout::Setup setup = setupWith({});
    setup.tools.set(1, parseCutter("flat:d=4,l=5,sd=4,so=6,holder=20x20").value());
    const Found found(kHead + "G0 X-15 Y15 Z-8\nG1 X20 F100\nG0 Z20\nM30\n", setup);
    const auto contact = found.contact("holder-collision");
    ASSERT_TRUE(contact.has_value());
    EXPECT_EQ(contact->part, ToolPart::holder);
    EXPECT_NEAR(contact->tip.y, 15, 1e-6);
    EXPECT_NEAR(contact->tip.z, -8, 1e-6);
    // The lower face of the holder is at the place in this moment, and reaches it.
    EXPECT_NEAR(contact->tip.z + 6, contact->place.z, 1e-3);
    EXPECT_LE(std::hypot(contact->place.x - contact->tip.x, contact->place.y - contact->tip.y), 10.02);
    EXPECT_GE(contact->place.x, -0.01) << "in the stock";
}

TEST(FoundContact, OfARapidIsOverWhatItRemoves) {
    const Found found(kHead + "G0 X60 Y10 Z5\nZ-3\nX25\nZ20\nM30\n", setupWith({}));
    const auto contact = found.contact("rapid-cuts");
    ASSERT_TRUE(contact.has_value());
    // It removes from its end at X25, with the radius of 2 mm, to the edge of the stock at X40.
    EXPECT_NEAR(contact->tip.x, (23 + 40) / 2.0, 0.6);
    EXPECT_EQ(contact->tip.y, 10);
    EXPECT_EQ(contact->tip.z, -3);
    EXPECT_EQ(contact->part, ToolPart::flutes);
}

TEST(FoundContact, OfTheTableIsTheLowestMoment) {
    const Found found(kHead + "G0 Z1\nG81 X20 Y15 Z-16 R1 F100\nG80\nG0 Z20\nM30\n", setupWith({}));
    const auto contact = found.contact("table-collision");
    ASSERT_TRUE(contact.has_value());
    EXPECT_NEAR(contact->tip.z, -16, 1e-9);
}

TEST(FoundContact, IsOfContactsOnly) {
    const Found found(kHead + "M5\nG1 Z-2 F100\nX10\nM3\nX20\nG0 Z20\nM30\n", setupWith({}));
    ASSERT_NE(found.finding("spindle-stopped"), nullptr);
    EXPECT_FALSE(found.contact("spindle-stopped").has_value());
}

} // namespace
} // namespace proveout
