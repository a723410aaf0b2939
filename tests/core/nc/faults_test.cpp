// SPDX-License-Identifier: GPL-3.0-or-later
// The files of corpus/faults-nc that need only features of this interpreter: what must be reported about
// each, and where.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

#include "core/nc/run/interpreter.h"

namespace proveout::test {

namespace {

namespace fs = std::filesystem;

const fs::path kFaults = fs::path(PROVEOUT_SHARED_DIR) / "corpus" / "faults-nc";

/// Messages as "line:column id", in sequence, and the number of motions.
struct Expectation {
    const char* file;
    std::size_t motions;
    std::vector<std::string> messages;
};

const std::vector<Expectation> kExpectations{
    {"empty.ngc", 0, {"1:1 no-motion"}},
    {"percent-only.ngc", 0, {"2:1 no-motion"}},
    {"nul-1k.ngc", 0, {"0:0 nc-binary"}},
    {"binary-64k.ngc", 0, {"0:0 nc-binary"}},
    {"bom-utf16le.ngc", 0, {"0:0 nc-encoding"}},
    {"eol-mixed.ngc", 3, {"2:6 cr-line-end"}},
    {"ctrl-z.ngc", 1, {}},
    {"dc-codes.ngc", 1, {"1:2 control-code", "4:1 after-program-end"}},
    {"utf8-comment.ngc", 1, {}},
    {"bad-utf8.ngc", 1, {"2:5 comment-nested"}},
    {"unicode-minus.ngc", 0, {"2:5 bad-character", "3:1 no-motion"}},
    {"nonascii-word.ngc", 0, {"2:5 bad-character", "3:1 no-motion"}},
    {"digits-1M.ngc", 0, {"2:253 line-long", "2:4 number-out-of-range", "3:1 no-motion"}},
    {"num-1e308.ngc",
     1,
     {"2:253 line-long", "2:4 number-out-of-range", "3:253 line-long", "3:4 number-out-of-range"}},
    {"num-nan.ngc", 0, {"2:5 number-missing", "3:1 no-motion"}},
    {"num-double-sign.ngc", 0, {"2:5 number-double-sign", "3:5 number-double-sign", "4:1 no-motion"}},
    {"num-two-points.ngc", 0, {"2:8 number-two-points", "3:1 no-motion"}},
    {"n-overflow.ngc", 2, {"1:1 n-long", "3:1 n-negative"}},
    {"unclosed-comment.ngc", 1, {"2:7 comment-unclosed"}},
    {"nested-comment.ngc", 0, {"2:4 comment-nested", "3:1 no-motion"}},
    {"modal-conflict.ngc",
     0,
     {"2:4 modal-conflict", "3:5 modal-conflict", "4:4 modal-conflict", "5:5 modal-conflict",
      "6:1 no-motion"}},
    {"dup-word.ngc", 0, {"2:7 word-twice", "3:1 no-motion"}},
    {"arc-no-centre.ngc", 1, {"3:1 arc-no-centre"}},
    {"arc-only-z.ngc", 2, {"3:1 arc-no-centre"}},
    {"arc-plane-words.ngc", 1, {"4:14 arc-word-off-plane"}},
    {"arc-zero.ngc", 1, {"3:10 arc-zero-radius", "4:10 arc-full-with-radius", "5:10 arc-full-with-radius"}},
    {"arc-centre-far.ngc", 2, {}},
    {"feed-none.ngc", 1, {"2:1 feed-missing"}},
    {"tiny-moves.ngc", 20000, {}},
    {"huge-coord.ngc", 4, {}},
    {"units-switch.ngc", 4, {}},
    {"semicolon.ngc", 2, {}},
    {"lower-and-squeezed.ngc", 3, {}},
    {"all-tabs.ngc", 1, {}},
    {"fanuc-no-point.nc", 1, {}},
    {"dwell-huge.ngc", 0, {"2:1 no-motion"}},
    {"rotary.ngc", 2, {"2:4 axis-unsupported", "3:8 axis-unsupported"}},
    {"block-delete-levels.ngc", 1, {"2:2 bad-character", "3:3 bad-character", "4:7 bad-character"}},
};

struct Answer {
    std::size_t motions = 0;
    std::vector<std::string> messages;
};

Answer answerTo(const fs::path& file) {
    Answer answer;
    const auto report = [&](const Diagnostics& diagnostics) {
        for (const Diagnostic& d : diagnostics)
            answer.messages.push_back(fmt::format("{}:{} {}", d.where.line, d.where.column, d.id));
    };
    const auto text = NcText::load(file);
    if (!text) {
        report(text.error());
        return answer;
    }
    InterpretOptions options;
    options.assumeStartAtZero = true;
    options.lint = false;
    options.maxRepeated = options.maxMotions = 1'000'000;
    const auto program = interpret(*text, options);
    answer.motions = program->motionCount();
    report(program->diagnostics());
    return answer;
}

} // namespace

TEST(Faults, AreReportedInTheirPlace) {
    if (!fs::exists(kFaults))
        GTEST_SKIP() << "the corpus is not here";
    for (const Expectation& expected : kExpectations) {
        const auto begin = std::chrono::steady_clock::now();
        const Answer answer = answerTo(kFaults / expected.file);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        EXPECT_EQ(answer.messages, expected.messages) << expected.file;
        EXPECT_EQ(answer.motions, expected.motions) << expected.file;
        EXPECT_LT(seconds, 0.5) << expected.file;
    }
}

TEST(Faults, OthersAreNeverSilent) {
    // The first is reported only with a tool table; the second is correct.
    const std::set<std::string> sound{"tool-unknown.ngc", "g92-stack.ngc"};
    if (!fs::exists(kFaults))
        GTEST_SKIP() << "the corpus is not here";
    int files = 0;
    for (const auto& entry : fs::directory_iterator(kFaults)) {
        const std::string name = entry.path().filename().string();
        const bool listed = std::any_of(kExpectations.begin(), kExpectations.end(),
                                        [&](const Expectation& e) { return name == e.file; });
        if (listed || sound.contains(name) || name.find(".oracle.") != std::string::npos)
            continue;
        ++files;
        EXPECT_FALSE(answerTo(entry.path()).messages.empty()) << name;
    }
    EXPECT_GT(files, 10);
}

} // namespace proveout::test
