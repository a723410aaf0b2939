// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report_page.h"

#include <gtest/gtest.h>
#include <string>

#include "core/report/base64.h"

namespace proveout {
namespace {

/// The vectors of RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
    EXPECT_EQ(base64Of(""), "");
    EXPECT_EQ(base64Of("f"), "Zg==");
    EXPECT_EQ(base64Of("fo"), "Zm8=");
    EXPECT_EQ(base64Of("foo"), "Zm9v");
    EXPECT_EQ(base64Of("foob"), "Zm9vYg==");
    EXPECT_EQ(base64Of("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64Of("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64Of(std::string("\0\xff\xfe", 3)), "AP/+");
}

nlohmann::ordered_json leastReport() {
    return {{"verdict", "unverified"},
            {"findings", nlohmann::ordered_json::array()},
            {"notChecked", nlohmann::ordered_json::array()},
            {"inputs", nlohmann::ordered_json::array()}};
}

TEST(ReportPage, ShowsTextsAsText) {
    nlohmann::ordered_json checked = leastReport();
    checked["findings"] = {{{"id", "x"},
                            {"severity", "fault"},
                            {"message", "<b>&\"cut\"</b>"},
                            {"hint", "a < b"},
                            {"waived", {{"owner", "<i>"}, {"reason", "</td>"}}}}};
    checked["notChecked"] = {{{"id", "y"}, {"title", "<u>"}, {"accepted", true}, {"reason", "<s>"}}};
    const std::string page =
        reportPage(checked, {"<title>.nc", "A & B", "Proveout", "2026-11-28"}, ReportPictures());
    for (const char* raw : {"<b>", "<i>", "<u>", "<s>", "<title>.nc", "A & B"})
        EXPECT_EQ(page.find(raw), std::string::npos) << raw;
    for (const char* shown : {"&lt;b&gt;&amp;&quot;cut&quot;&lt;/b&gt;", "a &lt; b", "&lt;i&gt;: &lt;/td&gt;",
                              "yes: &lt;s&gt;", "A &amp; B"})
        EXPECT_NE(page.find(shown), std::string::npos) << shown;
}

TEST(ReportPage, LeavesOutWhatIsNotThere) {
    const std::string page = reportPage(leastReport(), {"p.nc", "", "Proveout", "today"}, ReportPictures());
    EXPECT_NE(page.find("Nothing was found."), std::string::npos);
    for (const char* part : {"<h2>Part</h2>", "<h2>Islands</h2>", "<h2>Tools", "<img", "<script"})
        EXPECT_EQ(page.find(part), std::string::npos) << part;
}

} // namespace
} // namespace proveout
