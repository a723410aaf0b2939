// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/explained_differences.h"

#include <map>

#include <fmt/format.h>

#include "tests/core/nc/oracle_comparison.h"

namespace proveout::test {

namespace {

constexpr OracleTolerances kListing{1e-5, 1e-3};

/// What we refuse and LinuxCNC runs, by the id of our message, each with the reason.
const std::map<std::string, const char*> kStricter{
    {"number-double-sign", "X--1 is refused as a slip; within expressions signs may repeat"},
    {"feed-without-spindle",
     "with G95 LinuxCNC waits for a spindle that is stopped; the motion never begins"},
    {"synchronised-spindle",
     "with G33 LinuxCNC waits for a spindle whose speed is 0; the motion never begins"},
    {"arc-from-elsewhere", "an arc that begins elsewhere than the control takes the tool to be has no shape"},
    {"spline-handle", "G5 without I and J goes on from any motion in LinuxCNC, whatever its direction"},
    {"arc-turns", "more than 1000 turns"},
    {"number-negative", "a negative dwell is refused; LinuxCNC refuses that of -1 only"},
    {"number-out-of-range", "no number is larger than 1e12"},
    {"pitch", "a pitch of 0 or less"},
};

/// What LinuxCNC refuses and we run, by its message, each with the reason.
struct Milder {
    const char* text;
    const char* word; ///< in the line that it refuses
    const char* reason;
};
constexpr Milder kMilder[] = {
    {"Requested tool -1 not found", "43.2",
     "2.9.0~pre1 has no G43.2 with axis words; its manual and later releases have"},
    {"Invalid analog index", "M6", "outputs are not simulated, and their words are not checked"},
    {"P value not an integer with M19", "19", "turns of the spindle until it is oriented are not simulated"},
    {"Requested tool", "T", "a tool that the table does not have is told, but its motions are shown"},
    {"Bad character '%'", "%", "one % at the end is told and passed over"},
};

/// The reason for which only one of both refuses a line; null: there is none.
const char* reasonFor(const std::vector<std::string>& lines, const OracleAnswer& answer,
                      const Diagnostic* error) {
    const int theirs = answer.errorLine;
    const bool first = error != nullptr && (theirs <= 0 || error->where.line < theirs);
    if (const auto row = first ? kStricter.find(error->id) : kStricter.end(); row != kStricter.end())
        return row->second;
    for (const Milder& row : kMilder) {
        const std::size_t line = theirs > 0 ? static_cast<std::size_t>(theirs) : lines.size();
        if (answer.errorText.starts_with(row.text) && lines.at(line - 1).find(row.word) != std::string::npos)
            return row.reason;
    }
    return nullptr;
}

/// LinuxCNC refuses some blocks only when they are half done; what they did until then is not compared.
OracleAnswer upToError(const OracleAnswer& answer) {
    OracleAnswer before = answer;
    while (answer.errorLine > 0 && !before.records.empty() && before.records.back()["l"] == answer.errorLine)
        before.records.pop_back();
    return before;
}

} // namespace

Outcome outcomeOf(const std::vector<std::string>& lines, const OracleAnswer& answer, const Program& program) {
    if (answer.errorClass == "timeout")
        return {"endless", ""};
    std::string why;
    const OracleAnswer before = upToError(answer);
    const Diagnostic* error = firstError(program);
    const int theirs = answer.errorClass == "no-program-end" ? 0 : answer.errorLine;
    const int ours = error == nullptr ? 0 : error->where.line;
    if (ours != theirs) {
        if (const char* reason = reasonFor(lines, answer, error))
            return {reason, ""};
    }
    if (!sameSteps(before, program, answer.errorLine != 0 || ours != 0, kListing, why))
        return {"differs", why};
    if (ours != theirs) {
        return {"differs", fmt::format("refused at line {} ({}) / {} ({})", theirs, answer.errorText, ours,
                                       error == nullptr ? "" : error->id)};
    }
    if (ours == 0)
        return {"agrees", ""};
    return {"refused by both: " + answer.errorText.substr(0, 60), ""};
}

} // namespace proveout::test
