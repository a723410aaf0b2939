// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/text/nc_text.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "tests/core/temporary_folder.h"

namespace proveout {

namespace {

/// Splits like an editor, character by character.
std::vector<std::string> splitLines(const std::string& text) {
    std::vector<std::string> lines(1);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool pair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
        if (text[i] == '\n' || text[i] == '\r') {
            lines.emplace_back();
            i += pair ? 1 : 0;
        } else {
            lines.back() += text[i];
        }
    }
    return lines;
}

void expectSame(const NcText& text, const std::string& expected) {
    ASSERT_EQ(text.toString(), expected);
    ASSERT_EQ(text.size(), expected.size());
    const std::vector<std::string> lines = splitLines(expected);
    ASSERT_EQ(text.lineCount(), lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
        ASSERT_EQ(text.line(i), lines[i]) << "line " << i;
}

std::string randomText(std::mt19937& random, std::size_t most) {
    std::string text;
    for (std::size_t n = random() % (most + 1); n > 0; --n)
        text += "ab\n\r\nX1"[random() % 7];
    return text;
}

void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

} // namespace

TEST(NcText, SplitsLinesAsAnEditorDoes) {
    for (const char* text : {"", "\n", "\r", "\r\n", "a", "a\n", "a\r", "a\r\n", "a\nb", "a\rb", "a\r\nb",
                             "a\r\rb", "\n\r", "a\r\n\r\nb\r", "\r\r\n\n"}) {
        SCOPED_TRACE(text);
        expectSame(NcText(text), text);
    }
    EXPECT_EQ(NcText().lineCount(), 1U);
    EXPECT_EQ(NcText("G21\r\nX1\rX2\nX3\r\n\rM2").lineCount(), 6U);
}

TEST(NcText, SkipsTheByteOrderMark) {
    const NcText text("\xef\xbb\xbfG0\nX1");
    EXPECT_TRUE(text.hadByteOrderMark());
    expectSame(text, "G0\nX1");
    const NcText edited = text.replaced(0, 1, "M");
    EXPECT_TRUE(edited.hadByteOrderMark());
    expectSame(edited, "M0\nX1");
    EXPECT_FALSE(NcText("G0").hadByteOrderMark());
}

TEST(NcText, FindsTheFirstLoneCr) {
    EXPECT_EQ(NcText("a\nb\r\n").firstLoneCr(), 3U) << "none: the number of lines";
    EXPECT_EQ(NcText("a\nb\rc\rd").firstLoneCr(), 1U);
    EXPECT_EQ(NcText("a\nb\rc").replaced(4, 0, "\n").firstLoneCr(), 3U) << "it became a CR LF";
    EXPECT_EQ(NcText("a\nb\rc").replaced(3, 1, "").firstLoneCr(), 2U);
}

TEST(NcText, RandomEditsEqualAString) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        // Some texts are large compared with the pieces that are merged, some small.
        std::string expected = randomText(random, seed % 3 == 0 ? 40000 : 200);
        NcText text(expected);
        for (int edit = 0; edit < 60; ++edit) {
            const std::size_t offset = random() % (expected.size() + 1);
            const std::size_t most = random() % 8 == 0 ? 5000 : 4;
            const std::size_t removed =
                std::min<std::size_t>(random() % (most + 1), expected.size() - offset);
            const std::string inserted = randomText(random, random() % 8 == 0 ? 3000 : 4);
            const NcText before = text;
            const std::string beforeBytes = expected;
            text = text.replaced(offset, removed, inserted);
            expected.replace(offset, removed, inserted);
            ASSERT_NO_FATAL_FAILURE(expectSame(text, expected)) << "edit " << edit;
            ASSERT_EQ(before.toString(), beforeBytes) << "the older text must not change";
        }
    }
}

TEST(NcText, TypingIntoALargeTextCopiesNoMegabytes) {
    std::string bytes;
    for (int i = 0; i < 2'000'000; ++i)
        bytes += "G1 X1.234\n";
    NcText text(std::move(bytes));
    const auto begin = std::chrono::steady_clock::now();
    std::size_t offset = text.size() / 2;
    for (int i = 0; i < 1000; ++i)
        text = text.replaced(offset++, 0, "5");
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    // Copying the 20 MB once takes milliseconds, but a thousand times takes seconds.
    EXPECT_LT(seconds, 0.5);
    EXPECT_EQ(text.lineCount(), 2'000'001U);
}

TEST(NcText, LoadsWhatIsText) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "p.ngc";
    for (const std::string bytes : {"", "%\n%\n", "G0 (caf\xe9)\n", "G0 (\xc3\xa9)\n", "(\xff\xfe) G0",
                                    "\x12G0 X1\n\x14", "G0\tX1\f\nM2\x1a", "\xef\xbb\xbfG0"}) {
        writeBytes(file, bytes);
        EXPECT_TRUE(NcText::load(file)) << bytes;
    }
}

TEST(NcText, RefusesWhatIsNot) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "p.ngc";
    std::string wide;
    for (const char c : std::string("G0 X1\nM2\n"))
        wide += std::string(1, c) + '\0';
    struct Case {
        std::string bytes;
        const char* id;
    };
    for (const Case& c :
         {Case{std::string(1024, '\0'), "nc-binary"}, Case{"\x89PNG\r\n\x1a\nrest", "nc-binary"},
          Case{"G0 X1\n" + std::string(3, '\0'), "nc-binary"}, Case{"\xff\xfe" + wide, "nc-encoding"},
          Case{wide, "nc-encoding"}, Case{'\0' + wide, "nc-encoding"},
          Case{std::string("\xfe\xff\0G\0", 5), "nc-encoding"}}) {
        writeBytes(file, c.bytes);
        const auto text = NcText::load(file);
        ASSERT_FALSE(text);
        const Diagnostic& diagnostic = text.error().front();
        EXPECT_STREQ(diagnostic.id, c.id);
        EXPECT_EQ(diagnostic.where, TextRange()) << "it is about the whole file";
        EXPECT_EQ(diagnostic.file, file.string());
    }
    EXPECT_FALSE(NcText::load(folder.path() / "missing.ngc"));
    EXPECT_FALSE(NcText::load(folder.path()));
}

} // namespace proveout
