// SPDX-License-Identifier: GPL-3.0-or-later
// What a program receives from a probing motion, and when it is reported that this is assumed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/nc/run/interpreter.h"

namespace proveout {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A part whose top is at Z0, probed only straight down or up.
class FlatPart : public ProbeTarget {
public:
    Answer probe(const Program&, const Motion& motion, Seek seek, const WorkContext&) override {
        const bool touches = motion.start.z <= 0;
        if (touches == (seek == Seek::contact))
            return {Answer::Kind::already, motion.start};
        if ((motion.end.z <= 0) == touches)
            return {Answer::Kind::missed, motion.end};
        return {Answer::Kind::found, {motion.end.x, motion.end.y, 0}};
    }
};

class FlatParts : public ProbedPart {
public:
    std::unique_ptr<ProbeTarget> target() const override { return std::make_unique<FlatPart>(); }
    bool sameAs(const ProbedPart&) const override { return true; }
};

std::shared_ptr<const Program> probed(const std::string& text, DialectId dialect = DialectId::linuxcnc) {
    InterpretOptions options;
    options.dialect = dialect;
    options.lint = false;
    options.start = Vec3(0, 0, 10);
    options.part = {std::make_shared<const FlatParts>()};
    return interpret(NcText(text + "\nM30\n"), options);
}

std::vector<std::string> reported(const Program& program) {
    std::vector<std::string> texts;
    for (const Diagnostic& diagnostic : program.diagnostics())
        texts.push_back(std::to_string(diagnostic.where.line) + " " + diagnostic.id);
    return texts;
}

TEST(Probe, StopsWhereItTouchesAndCutsNothing) {
    const auto program = probed("F100\nG38.2 Z-5\nG0 Z10\nX5");
    ASSERT_EQ(program->motionCount(), 3U);
    EXPECT_EQ(program->motion(0).end, Vec3(0, 0, 0));
    EXPECT_TRUE(program->motion(0).probing);
    EXPECT_FALSE(program->motion(1).probing);
    EXPECT_TRUE(program->asksForStock());
    EXPECT_THAT(reported(*program), ElementsAre("2 probe-contact"));
    EXPECT_THAT(program->diagnostics()[0].arguments, ElementsAre("0.000", "0.000", "0.000"));
    EXPECT_FALSE(program->unverified()); // nothing depends on where it touched
}

TEST(Probe, LeavesItsResultInTheUnitOfTheProgram) {
    const auto program = probed("G10 L2 P1 Z2.54\nG20\nF5\nG38.2 Z-5\nG0 Z1\nG0 X#5070 Z[#5063+1]");
    EXPECT_NEAR(program->motion(2).end.z, 25.4, 1e-9);
    EXPECT_NEAR(program->motion(2).end.x, 25.4, 1e-9);
    EXPECT_THAT(reported(*program), ElementsAre("4 probe-contact", "6 probe-used"));
    EXPECT_THAT(program->diagnostics()[0].arguments[2], "-2.540");
    EXPECT_TRUE(program->unverified());
    EXPECT_FALSE(program->motion(1).unverified);
    EXPECT_TRUE(program->motion(2).unverified);
}

TEST(Probe, ItsUseIsReportedOnceWhereTheProgramContinuesFromThere) {
    EXPECT_THAT(reported(*probed("F100\nG38.2 Z-5\nG91 G0 Z1\nX1")),
                ElementsAre("2 probe-contact", "3 probe-used"));
    EXPECT_THAT(reported(*probed("F100\nG38.2 Z-5\nG1 X4\nZ5")),
                ElementsAre("2 probe-contact", "3 probe-used"));
    EXPECT_THAT(reported(*probed("F100\nG38.2 Z-5\nG92 Z0\nG0 Z5")),
                ElementsAre("2 probe-contact", "3 probe-used"));
    EXPECT_THAT(reported(*probed("F100\nG38.2 Z-5\nG10 L20 P1 Z0\nG0 Z5")),
                ElementsAre("2 probe-contact", "3 probe-used"));
    EXPECT_THAT(reported(*probed("F100\nG38.2 Z-5\nG92 X0\nG0 Z5\nG91 Z1")), ElementsAre("2 probe-contact"));
    EXPECT_THAT(reported(*probed("F100\nG38.2 Z-5\nG0 Z5\no1 if [#5070 EQ 1]\nX1\no1 endif")),
                ElementsAre("2 probe-contact", "4 probe-used"));
    EXPECT_THAT(reported(*probed("F100\nG38.2 Z-5\nG0 Z5\n#5063=1\nX1")), ElementsAre("2 probe-contact"));
}

TEST(Probe, MissesByItsCode) {
    EXPECT_THAT(reported(*probed("F100\nG38.2 Z5")), ElementsAre("2 probe-missed"));
    const auto silent = probed("F100\nG38.3 Z5\nG0 Z9\nX#5070 Z#5063");
    EXPECT_EQ(silent->motion(0).end.z, 5);
    EXPECT_EQ(silent->motion(2).end, Vec3(0, 0, 5));
    EXPECT_THAT(reported(*silent), ElementsAre("4 probe-used"));
    EXPECT_THAT(reported(*probed("F100\nG1 Z-2\nG38.4 Z-1")), ElementsAre("3 probe-held"));
    EXPECT_THAT(reported(*probed("F100\nG1 Z-2\nG38.5 Z-1\nG0 Z5")), IsEmpty());
}

TEST(Probe, IsRefusedWhereItHasWhatItSeeks) {
    const auto program = probed("F100\nG1 Z0\nG38.3 Z-5\nG38.5 Z7\nG38.4 Z8");
    EXPECT_THAT(reported(*program), ElementsAre("3 probe-touches", "4 probe-release", "5 probe-release"));
    ASSERT_EQ(program->motionCount(), 3U);
    EXPECT_EQ(program->motion(1).end.z, 0); // G38.5
}

TEST(Probe, NeedsAWay) {
    EXPECT_THAT(reported(*probed("F100\nG91 G38.2 X0")), ElementsAre("2 probe-too-close", "3 no-motion"));
    // The offsets of G92 leave a difference of one bit between both ends.
    const auto program = probed("F100\nG92 X18. Y-9.991945\nG91 G0 X7\nG38.5 X-15. Y13.276\nX0");
    EXPECT_THAT(reported(*program), ElementsAre("4 probe-free", "5 probe-too-close"));
    EXPECT_THAT(reported(*probed("F100\nG91 G38.3 X0.0001")), IsEmpty());
}

TEST(Probe, SkipMotionOfFanucKeepsWhereItStopped) {
    const auto program =
        probed("F100\nG31 Z-5.\nG0 Z9.\nX1.\nG0 Z[#5063+2]\nG31 Z4.\nG0 Z#5063", DialectId::fanuc);
    ASSERT_EQ(program->motionCount(), 6U);
    EXPECT_EQ(program->motion(0).end.z, 0);
    EXPECT_TRUE(program->motion(0).probing);
    EXPECT_EQ(program->motion(3).end.z, 2);
    EXPECT_THAT(reported(*program), ElementsAre("2 probe-contact", "5 probe-used"));
    EXPECT_THAT(reported(*probed("F100\nG31 Z5.\nG0 Z9.", DialectId::fanuc)), IsEmpty());
}

TEST(Probe, SkipMotionOfMachLeavesItsOwnParameters) {
    const auto program = probed("F100\nG31 Z-5\nG0 Z9\nX1\nZ[#2002+2]", DialectId::mach);
    ASSERT_EQ(program->motionCount(), 4U);
    EXPECT_EQ(program->motion(3).end.z, 2);
    EXPECT_THAT(reported(*program), ElementsAre("2 probe-contact", "5 probe-used"));
}

TEST(Probe, OfFanucIsUsedInAStatement) {
    EXPECT_THAT(reported(*probed("F100\nG31 Z-5.\nG0 Z9.\nIF[#5063 GT 1]THEN #1=2\nX1.", DialectId::fanuc)),
                ElementsAre("2 probe-contact", "4 probe-used"));
}

TEST(Probe, WithoutATargetReachesItsEndUnverified) {
    const auto program = interpret(NcText("G0 X0 Y0 Z5\nF100\nG38.2 Z-5\nG0 Z5\nM2\n"));
    EXPECT_EQ(program->motion(1).end.z, -5);
    EXPECT_TRUE(program->motion(1).probing);
    EXPECT_TRUE(program->asksForStock());
    EXPECT_TRUE(program->unverified());
}

} // namespace
} // namespace proveout
