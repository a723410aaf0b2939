// SPDX-License-Identifier: GPL-3.0-or-later
#include <ctime>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/cutter/tool_comment.h"

namespace proveout {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

struct CommentRow {
    const char* comment;
    int number; ///< -1: none
    const char* spec;
    bool inch = false;
};

std::string specOf(const ToolComment& tool) {
    if (!tool.isComplete())
        return "nothing";
    const auto made = makeCutter(tool);
    return made ? made->cutter.spec() : "no cutter";
}

class KnownComments : public testing::TestWithParam<CommentRow> {};

TEST_P(KnownComments, StateTheTool) {
    const CommentRow& row = GetParam();
    const ToolComment tool = readToolComment(row.comment, row.inch);
    EXPECT_EQ(specOf(tool), row.spec) << row.comment;
    EXPECT_EQ(tool.number.value_or(-1), row.number) << row.comment;
}

// The expected mm of sizes in inches are converted by hand: 1/4" is 6.35 mm.
const CommentRow kFusion[] = {
    {"T1 D=6. CR=0. - ZMIN=-5. - FLAT END MILL", 1, "flat:d=6"},
    {"T3 D=0.125 CR=0.0625 - ZMIN=-0.54 - BALL END MILL", 3, "ball:d=3.175", true},
    {"T12 D=1.4 CR=0 - ZMIN=-1 - flat end mill", 12, "flat:d=1.4"},
    {"T11 D=0.5 CR=0.03 - ZMIN=0.1475 - bullnose end mill", 11, "bull:d=12.7,r=0.762", true},
    {"T1  D=4. CR=0. TAPER=90deg - ZMIN=-1. - spot drill - 4mm Spot Drill", 1, "spot:d=4,angle=90"},
    {"T9 D=2.5 CR=0. TAPER=118deg - ZMIN=-4.751 - taladrar", 9, "drill:d=2.5,angle=118"},
    {"T6  D=6. CR=0. TAPER=45deg - ZMIN=-1.3 - chamfer mill", 6, "chamfer:d=6,angle=90,tip=0"},
    {"T2 D=50. CR=0. TAPER=45DEG - ZMIN=0. - FACE MILL", 2, "face:d=50,angle=45,h=5,r=0"},
    {"T4 D=3. CR=0.5 TAPER=5DEG - ZMIN=-3. - TAPERED MILL", 4, "taper:d=3,angle=5,h=12,r=0.5"},
    {"T3 D=8. CR=0. - ZMIN=-9. - RIGHT HAND TAP", 3, "tap:d=8,tip=5.6,lead=4.8"},
};
const CommentRow kMastercam[] = {
    {" T1 | 1/2 FLAT ENDMILL | H1 | DIA. OFF. 1 | TOOL DIA. - .5 ", 1, "flat:d=12.7", true},
    {" T1 | 1/4 FLAT ENDMILL | H1 | D1 | TOOL DIA. - .25 ", 1, "flat:d=6.35", true},
    {"T2 - 3/8 BALL ENDMILL - H2 - D2 - D0.3750\" - R0.1875\"", 2, "ball:d=9.525"},
    {"T1 | 10. FLAT ENDMILL | H1 | D10.", 1, "flat:d=10"},
    // If several numbers are possible, the tool number is that of the register and the other one is the size.
    {"T5 D5 12MM ENDMILL", 5, "flat:d=12"},
    {"12MM ENDMILL D5 T5", 5, "flat:d=12"},
    {"T5 D5 1/2 ENDMILL", 5, "flat:d=12.7", true},
    {"T5 D5 ENDMILL", 5, "flat:d=5"},
    {"T6 D6 R0.5MM BULLNOSE ENDMILL", 6, "bull:d=6,r=0.5"},
    {"T6 D6MM 12MM ENDMILL", 6, "flat:d=6"},
    {"T5 | 1 1/4 FACE MILL | H5", 5, "face:d=31.75,angle=90,h=3.175"},
    {" 1/16 FLAT ENDMILL TOOL - 1 DIA. OFF. - 1 LEN. - 1 DIA. - .0625", 1, "flat:d=1.5875", true},
    {"T4 | 1/4 SPOT DRILL | H4", 4, "spot:d=6.35,angle=90"},
};
const CommentRow kOtherSystems[] = {
    {"Tool: D = 3.0 mm  type END flutes 2", -1, "flat:d=3"},                    // BlenderCAM
    {" T0 : 3.175 ", 0, "flat:d=3.175"},                                        // CamBam
    {"MSG, Change tool bit to mill diameter 0.00787in", -1, "flat:d=0.199898"}, // pcb2gcode
    {"MSG, Change tool bit to drill size 0.6mm", -1, "drill:d=0.6,angle=118"},
    {"MSG, Change to Tool Dia = 0.8000 ||| Total drills for tool T1 = 12", 1,
     "drill:d=0.8,angle=118"}, // FlatCAM
    {"MSG, Change to tool dia=0.2000", -1, "flat:d=0.2"},
    {"1 = End Mill {6 mm}", 1, "flat:d=6"}, // Vectric
    {"T2 = End Mill {0.5 inches}", 2, "flat:d=12.7"},
    {"2 = V-Bit {60 deg 12 mm}", 2, "cone:d=12,angle=60"},
    {"Tool: End Mill {0.2500 inch} UpDown", -1, "flat:d=6.35"},
    {"TC: 5mm Endmill", -1, "flat:d=5"}, // FreeCAD
    {"Compensated Tool Path. Diameter: 33.0", -1, "flat:d=33"},
    {"TOOL/MILL,3.175, 0.00, 0.00, 0.00", -1, "flat:d=3.175"},    // Carbide Create
    {" tool#=1 flute=6 len=20 unit=metric", 1, "flat:d=6"},       // Kiri:Moto
    {"TOOL -1- MILL DIA 10.0 R0. MM", 1, "flat:d=10"},            // SolidCAM
    {"TOOL : MILL_D16_R0.8 / DIA : 16.0", -1, "bull:d=16,r=0.8"}, // NX
    {"Bit diameter: 1/8\"", -1, "flat:d=3.175"},                  // SketchUcam
    {"Turret No. :   0   Diameter :6.350     MM   BALLNOSE  ", 0, "ball:d=6.35"},
    {" Tool: 3.0mm", -1, "flat:d=3"}, // UGS
};
const CommentRow kByHand[] = {
    {"FREZA D10", -1, "flat:d=10"},
    {"D10", -1, "flat:d=10"},
    {"TOOL 1 - 10. DIA FLAT ENDMILL", 1, "flat:d=10"},
    {"T3 .5 DIA BALL ENDMILL 2 FLUTES", 3, "ball:d=0.5"},
    {"Werkzeug T1: Schaftfraeser 12mm", 1, "flat:d=12"},
    {" 20mm 390 ENDMILL ", -1, "flat:d=20"},
    {"ball-end mill D20", -1, "ball:d=20"},
    {" and Cutter is assumed to be a 10mm ball nose ", -1, "ball:d=10"},
    {" 1/16\" endmill diameter ", -1, "flat:d=1.5875"},
    {"刀具 Ø10 ☃", -1, "flat:d=10"},
    {"SCHAFTFRÄSER D6,5", -1, "flat:d=6.5"},
    {"Kugelfräser Ø 6", -1, "ball:d=6"},
    {"фреза D8", -1, "flat:d=8"},
    {"CHAMFER TOOL 6MM ", -1, "chamfer:d=6,angle=90,tip=0"},
    {"TOOL 7 D63 FACE MILL R0.8", 7, "face:d=63,angle=90,h=6.3,r=0.8"},
    {"T05 6FL 12MM ENDMILL", 5, "flat:d=12"},
    {"EM10. 3FL", -1, "flat:d=10"},
    {"T7 - M8X1.25 TAP", 7, "tap:d=8,tip=5.6,lead=4.8"},
    {"TOOL #4 1/4 BALL", 4, "ball:d=6.35"},
    {"6.8MM DRILL 140 DEG", -1, "drill:d=6.8,angle=140"},
};
const CommentRow kNoTool[] = {
    {"cutter radius compensation off", -1, "nothing"},
    {"drill three bolt holes on a 5\" diameter", -1, "nothing"},
    {"drill 17 evenly-spaced bolt holes on a 4\" diameter", -1, "nothing"},
    {"Material Thickness: 3/4\"", -1, "nothing"},
    {"Feed rate: 100\"/min", -1, "nothing"},
    {"Tool step over: 0.3mm", -1, "nothing"},
    {"set maximum deviation from commanded toolpath", -1, "nothing"},
    {"Retract to tool change height 25 mm", -1, "nothing"},
    {"POCKET DIAMETER 40", -1, "nothing"},
    {"END OF PROGRAM 1", -1, "nothing"},
    {"TOOL LIFE EXPIRED", -1, "nothing"},
    {"T99 D=6 CR=3 - PROBE", -1, "nothing"},
    {"MSG, Change tool bit to mill diameter 0.00000in", -1, "nothing"},
    {"1\" square with rounded corners", -1, "nothing"},
    {"cutter dia + 2 x min fillet radius", -1, "nothing"},
    {"ISO 1.5 THREAD MILL", -1, "nothing"},
    {"{$TOOLDIA1}MM DRILL", -1, "nothing"},
    {"3.14*$TOOLDIA2", -1, "nothing"},
    {"T1 D=-6.", -1, "nothing"},
    {"T1 D=99999999999999999999999", -1, "nothing"},
    {"T999999999999 D=6", -1, "nothing"},
    {"T1 D=5000. ENDMILL", -1, "nothing"},
    {"", -1, "nothing"},
};

INSTANTIATE_TEST_SUITE_P(Fusion, KnownComments, testing::ValuesIn(kFusion));
INSTANTIATE_TEST_SUITE_P(Mastercam, KnownComments, testing::ValuesIn(kMastercam));
INSTANTIATE_TEST_SUITE_P(OtherSystems, KnownComments, testing::ValuesIn(kOtherSystems));
INSTANTIATE_TEST_SUITE_P(ByHand, KnownComments, testing::ValuesIn(kByHand));
INSTANTIATE_TEST_SUITE_P(NoTool, KnownComments, testing::ValuesIn(kNoTool));

TEST(ToolComment, ListsWhatIsADefault) {
    const auto defaultsOf = [](const char* comment) {
        return makeCutter(readToolComment(comment, false)).value().defaults;
    };
    EXPECT_THAT(defaultsOf("T1 D=6. CR=0. - FLAT END MILL"), ElementsAre("l"));
    EXPECT_THAT(defaultsOf("Tool: 3.0mm"), ElementsAre("shape", "l"));
    EXPECT_THAT(defaultsOf("MSG, Change tool bit to drill size 0.6mm"), ElementsAre("angle", "l"));
    EXPECT_THAT(defaultsOf("T1 D=6 FLUTE LENGTH=12 ENDMILL"), testing::IsEmpty());
}

TEST(ToolComment, MayBeWrittenOverSeveralComments) {
    ToolComment tool = readToolComment("*** TOOL DIAMETER = 0.500000 ***", true);
    EXPECT_TRUE(extend(tool, readToolComment("*** TOOL LENGTH = 3.000000 ***", true)));
    EXPECT_TRUE(extend(tool, readToolComment("*** TOOL NUMBER = 3 ***", true)));
    EXPECT_EQ(tool.number, 3);
    EXPECT_EQ(specOf(tool), "flat:d=12.7");
    EXPECT_FALSE(extend(tool, readToolComment("*** TOOL DIAMETER = 0.25 ***", true)))
        << "another tool begins";
    EXPECT_EQ(specOf(tool), "flat:d=12.7");

    ToolComment pycam = readToolComment("shape = CylindricalCutter", false);
    EXPECT_TRUE(extend(pycam, readToolComment("tool_radius = 0.5", false)));
    EXPECT_EQ(specOf(pycam), "flat:d=1");
}

TEST(ToolComment, HostileTextTakesBoundedTime) {
    const std::clock_t begin = std::clock();
    std::string drills;
    for (int i = 0; i < 300'000; ++i)
        drills += "TOOL DRILL 1/2 ";
    EXPECT_TRUE(readToolComment(drills, false).isComplete());
    EXPECT_FALSE(readToolComment(std::string(10'000'000, '9'), false).isComplete());
    std::mt19937 random(1);
    const std::string letters = "TDRMILBAEND=:.-/'\"#{}|Ø0123456789 \xC3\xFF";
    for (int i = 0; i < 5'000; ++i) {
        std::string text;
        for (int c = 0; c < 80; ++c)
            text += letters[random() % letters.size()];
        const ToolComment tool = readToolComment(text, i % 2 == 0);
        if (tool.isComplete()) {
            const auto made = makeCutter(tool);
            EXPECT_TRUE(!made || (made->cutter.radius() > 0 && made->cutter.radius() < 5000)) << text;
        }
    }
    EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC);
}

} // namespace
} // namespace proveout
