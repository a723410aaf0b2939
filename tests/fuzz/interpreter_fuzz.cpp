// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer for `interpret`: the last byte selects the options, everything before it is the text.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/nc/codes/dialects.h"
#include "core/nc/run/resumable_interpreter.h"
#include "tests/core/nc/program_equality.h"
#include "tests/core/nc/program_invariants.h"

namespace proveout::test {

namespace {

/// A line end, which is at the end of most programs, selects the default options.
constexpr unsigned kPlain = '\n';

enum Choice : unsigned {
    kBlockDelete = 1,
    kStartAtZero = 2,
    kStart = 4,
    kTools = 8,
    kFew = 16,     ///< limits motions and messages
    kDialect = 32, ///< the bits above it select which one
};

/// One of this many texts is run three times.
constexpr std::size_t kComparedOf = 8;

ToolOffsets someTools() {
    return ToolOffsets({{1, {Vec3(0, 0, 50), 10}}, {2, {Vec3(1, -1, 80), 0}}, {3, {Vec3(0), -6}}});
}

InterpretOptions optionsOf(unsigned choice) {
    InterpretOptions options;
    options.file = "fuzz.ngc";
    if (const std::size_t dialect = choice / kDialect; dialect < dialects().size())
        options.dialect = dialects()[dialect].id;
    else
        options.dialect.reset(); // detected from the text
    options.blockDelete = (choice & kBlockDelete) != 0;
    options.assumeStartAtZero = (choice & kStartAtZero) != 0;
    if ((choice & kStart) != 0)
        options.start = Vec3(10, -20, 30);
    if ((choice & kTools) != 0)
        options.tools = someTools();
    // An execution must be fast.
    options.maxDiagnostics = (choice & kFew) != 0 ? 10 : options.maxDiagnostics;
    options.maxMotions = (choice & kFew) != 0 ? 5 : 400;
    options.maxRepeated = 400;
    return options;
}

void require(bool kept, const std::string& promise) {
    if (kept)
        return;
    std::fprintf(stderr, "broken promise: %s\n", promise.c_str());
    std::abort();
}

/// The same text in several pieces, as after edits.
NcText edited(const std::string& text) {
    const std::size_t half = text.size() / 2;
    return NcText(text.substr(0, half) + "G1 X9" + text.substr(half)).replaced(half, 5, "");
}

void requireSame(const Program& program, const Program& other, const std::string& promise) {
    const std::string found = difference(program, other);
    require(found.empty(), promise + ": " + found);
}

void run(const std::string& bytes, unsigned choice) {
    const NcText text(bytes);
    const InterpretOptions options = optionsOf(choice);
    const auto program = interpret(text, options);
    const std::string broken = brokenPromise(text, options, *program);
    require(broken.empty(), broken);
    if (bytes.size() % kComparedOf != 0)
        return;
    requireSame(*program, *interpret(text, options), "the same text means the same");
    // The byte order mark is detected when a text is created, but not in edits.
    if (!text.hadByteOrderMark())
        requireSame(*program, *interpret(edited(bytes), options), "an edited text means what it says");
    // First half of the text, so that the whole resumes at its end or before.
    ResumableInterpreter interpreter(1);
    static_cast<void>(
        interpreter.interpret(text.replaced(text.size() / 2, text.size() - text.size() / 2, ""), options));
    requireSame(*program, *interpreter.interpret(text, options),
                "a run that is taken up again says the same");
}

} // namespace

} // namespace proveout::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 0)
        proveout::test::run(std::string(data, data + size - 1), data[size - 1] ^ proveout::test::kPlain);
    return 0;
}
