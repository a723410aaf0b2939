// SPDX-License-Identifier: GPL-3.0-or-later
// How the messages of the command line are worded, read from its sources: a sentence begins with a capital
// and ends with a full stop. Those of the core are rows, which findings_test looks at.
#include <array>
#include <cstddef>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace proveout {
namespace {

/// The text of adjoining literals as one.
std::string joined(const std::string& literals) {
    static const std::regex kSeam("\"\\s*\"");
    const std::string text = std::regex_replace(literals, kSeam, "");
    const std::size_t begin = text.find('"') + 1;
    return text.substr(begin, text.rfind('"') - begin);
}

/// A placeholder, a quotation or a code may begin a sentence; what it ends with may come as an argument.
bool isSentence(const std::string& text) {
    const bool begins = !text.empty() && (text[0] < 'a' || text[0] > 'z');
    return begins && (text.ends_with(".") || text.ends_with(": {}"));
}

TEST(Sentences, BeginWithACapitalAndEndWithAFullStop) {
    const std::string literals = "((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)";
    const std::string marked = "\\s*PROVEOUT_TEXT\\(\\s*\"Core\",\\s*" + literals;
    // Behind an id with a hyphen, or in the place of a text.
    const std::array<std::regex, 3> kSentences{
        std::regex("\"[a-z0-9]+(?:-[a-z0-9]+)+\",\\s*(?:PROVEOUT_TEXT\\(\\s*\"Core\",\\s*)?" + literals),
        std::regex("(?:text|hint) =" + marked), std::regex("fail\\([^;]*?" + marked)};
    std::size_t found = 0;
    for (const SourceFile& file : sourceTree()) {
        if (!file.isCpp() || !file.in("app/cli"))
            continue;
        for (const std::regex& pattern : kSentences) {
            for (std::sregex_iterator each(file.text.begin(), file.text.end(), pattern), end; each != end;
                 ++each) {
                ++found;
                const std::string text = joined((*each)[1]);
                EXPECT_TRUE(isSentence(text)) << file.path << ": " << text;
            }
        }
    }
    EXPECT_GT(found, 10U) << "a rule that reads nothing would hold for ever";
}

} // namespace
} // namespace proveout
