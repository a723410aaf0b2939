// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a check as a page.
#include <cstdlib>
#include <regex>
#include <string>

#include "tests/app/command_line.h"

namespace proveout {
namespace {

const std::string kOptions = " --stock 40x30x10 --grid 0.5 --tool 1=flat:d=6,l=20 ";
const std::string kProgram =
    "G21 G90 G17\nT1 M6\nS5000 M3\nG0 X10 Y15 Z5\nG1 Z-3 F200\nX30 F600\nG0 Z5\nM5\nM30\n";

class CliReport : public CommandLine {
protected:
    /// The part lacks the last 5 mm of the slot.
    void SetUp() override {
        std::string design = kProgram;
        design.replace(design.find("X30"), 3, "X25");
        write("design.nc", design);
        EXPECT_EQ(run("simulate design.nc" + kOptions + "--export part.stl").exitCode, 0);
        write("p.nc", kProgram);
    }
    Finished check(const std::string& more) { return run("check p.nc" + kOptions + more); }
    /// Without what differs from one run to the next.
    static std::string lasting(const std::string& page) {
        return std::regex_replace(page, std::regex("\\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d"), "DATE");
    }
};

TEST_F(CliReport, EachNumberOfThePageIsThatOfTheJson) {
    const Finished done = check("--part part.stl --report r.html --json");
    ASSERT_EQ(done.exitCode, 1) << done.err;
    const nlohmann::json json = done.json();
    const std::string page = read("r.html");
    static const std::regex kNumber("<data value=\"([^\"]*)\" data-key=\"([^\"]*)\">([^<]*)</data>");
    int numbers = 0;
    for (std::sregex_iterator at(page.begin(), page.end(), kNumber); at != std::sregex_iterator(); ++at) {
        ++numbers;
        const nlohmann::json::json_pointer pointer((*at)[2].str());
        ASSERT_TRUE(json.contains(pointer)) << (*at)[2];
        EXPECT_EQ(json[pointer].dump(), (*at)[1].str()) << (*at)[2];
        const std::string shown = (*at)[3].str();
        if (shown.find(':') == std::string::npos) { // otherwise a time
            EXPECT_NEAR(std::strtod(shown.c_str(), nullptr), json[pointer].get<double>(), 0.0501) << (*at)[2];
        }
    }
    EXPECT_GT(numbers, 30);
    // No number but those: the text without them, scripts and attributes has none but in names and sentences.
    EXPECT_NE(page.find("line <data"), std::string::npos) << "the block of the island";
    EXPECT_NE(page.find("data:image/png;base64,iVBOR"), std::string::npos);
}

TEST_F(CliReport, IsTheSameTwiceAndLoadsNothing) {
    ASSERT_EQ(check("--part part.stl --report a.html").exitCode, 1);
    ASSERT_EQ(check("--part part.stl --report b.html --threads 1").exitCode, 1);
    const std::string page = read("a.html");
    EXPECT_EQ(lasting(page), lasting(read("b.html")));
    const std::string markup = page.substr(0, page.find("<script>"));
    for (const char* outside : {"src=\"http", "href=", "@import", "url("})
        EXPECT_EQ(markup.find(outside), std::string::npos) << outside;
    EXPECT_NE(markup.find("default-src 'none'"), std::string::npos);
}

TEST_F(CliReport, WithoutAPartItHasTheVerdictAndThePictureOfTheStock) {
    ASSERT_EQ(check("--report r.html").exitCode, 2);
    const std::string page = read("r.html");
    EXPECT_NE(page.find("class=\"badge unverified\">unverified"), std::string::npos);
    EXPECT_NE(page.find("The stock at the end of the program, from above."), std::string::npos);
    EXPECT_EQ(page.find("<h2>Part</h2>"), std::string::npos);
    EXPECT_EQ(page.find("id=\"view\""), std::string::npos);
}

TEST_F(CliReport, HostileNamesStayText) {
    write("a<script>alert(1)&.nc", kProgram);
    const Finished done = run("check 'a<script>alert(1)&.nc'" + kOptions + "--report r.html");
    EXPECT_EQ(done.exitCode, 2) << done.err;
    const std::string page = read("r.html");
    EXPECT_EQ(page.find("<script>alert"), std::string::npos);
    EXPECT_NE(page.find("a&lt;script&gt;alert(1)&amp;.nc"), std::string::npos);
}

TEST_F(CliReport, IsOfOneProgramAndIsWrittenOrNot) {
    write("q.nc", kProgram);
    EXPECT_EQ(run("check p.nc q.nc" + kOptions + "--report r.html").exitCode, 3);
    EXPECT_EQ(check("--report /proc/none/r.html").exitCode, 3);
    EXPECT_EQ(check("--report p.nc").exitCode, 3) << "that is the program";
    // A program that cannot be read has a report as well.
    EXPECT_EQ(run("check none.nc --report r.html").exitCode, 3);
}

} // namespace
} // namespace proveout
