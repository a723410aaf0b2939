// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/explained_differences.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

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
    {"diameter-mode", "diameters are of lathes"},
    {"nurbs-weight", "a first control point without weight has a weight of -1 in LinuxCNC"},
    {"nurbs-open", "a NURBS without G5.3 is dropped by LinuxCNC without a word"},
};

/// Our messages about programs that do not come to an end.
const std::set<std::string> kEndless{"too-many-steps", "too-many-again", "main-return"};

/// Codes of LinuxCNC that are known and not supported.
const std::set<std::string> kNotOfMills{"G17.1", "G18.1", "G19.1", "G70", "G71", "G72", "G76"};

/// Motions in step with the spindle.
const std::set<std::string> kInStep{"G33", "G33.1"};

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

/// The reason for which only one of both refuses a line, and whose records end there.
struct Reason {
    const char* text = nullptr; ///< null: there is none
    Extent extent = Extent::whole;
};

Reason reasonFor(const std::vector<std::string>& lines, const OracleAnswer& answer, const Diagnostic* error) {
    const int theirs = answer.errorLine;
    const bool first = error != nullptr && (theirs <= 0 || error->where.line < theirs);
    if (const auto row = first ? kStricter.find(error->id) : kStricter.end(); row != kStricter.end())
        return {row->second, Extent::oursBegins};
    if (first && error->id == std::string("code-unsupported") &&
        kNotOfMills.contains(error->arguments.front()))
        return {"lathe cycles, and the planes of axes that there are not", Extent::oursBegins};
    for (const Milder& row : kMilder) {
        const std::size_t line = theirs > 0 ? static_cast<std::size_t>(theirs) : lines.size();
        if (answer.errorText.starts_with(row.text) && lines.at(line - 1).find(row.word) != std::string::npos)
            return {row.reason, Extent::oracleBegins};
    }
    return {};
}

/// LinuxCNC refuses some blocks only when they are half done; what they did until then is not compared.
OracleAnswer upToError(const OracleAnswer& answer) {
    OracleAnswer before = answer;
    while (answer.errorLine > 0 && !before.records.empty() && before.records.back()["l"] == answer.errorLine)
        before.records.pop_back();
    return before;
}

/// A program without end: we must stop at a limit, or at M99, and agree until then.
Outcome outcomeOfEndless(const OracleAnswer& answer, const OurAnswer& ours) {
    const bool noticed = std::ranges::any_of(ours.whole.diagnostics(), [](const Diagnostic& diagnostic) {
        return kEndless.contains(diagnostic.id);
    });
    if (!noticed)
        return {"differs", "LinuxCNC does not come to an end"};
    std::string why;
    if (!sameSteps(answer, ours.upToError, Extent::oursBegins, kListing, why))
        return {"differs", why};
    return {"endless in both", ""};
}

Outcome outcomeOfBeginning(const OracleAnswer& beginning, const Program& ours, const char* reason) {
    std::string why;
    if (!sameSteps(beginning, ours, Extent::oracleBegins, kListing, why))
        return {"differs", why};
    return {reason, ""};
}

Outcome outcomeOfLost(const OracleAnswer& answer, const OurAnswer& ours) {
    return outcomeOfBeginning(
        upToError(answer), ours.whole,
        "the stand-alone machine changes tools and forgets the length that no motion has used yet");
}

/// LinuxCNC runs G33 and its like in compensation, without the spindle; the motion before depends on theirs.
Outcome outcomeOfForbidden(const OracleAnswer& answer, const OurAnswer& ours) {
    OracleAnswer beginning = upToError(answer);
    const std::size_t known = ours.upToError.motionCount();
    beginning.records.resize(std::min(beginning.records.size(), known - std::min<std::size_t>(known, 1)));
    return outcomeOfBeginning(beginning, ours.whole,
                              "LinuxCNC compensates motions in step with the spindle, without it");
}

} // namespace

Outcome outcomeOf(const std::vector<std::string>& lines, const OracleAnswer& answer, const OurAnswer& ours) {
    if (answer.errorClass == "timeout")
        return outcomeOfEndless(answer, ours);
    const Diagnostic* error = firstError(ours.whole);
    if (answer.lost)
        return outcomeOfLost(answer, ours);
    if (error != nullptr && error->id == std::string("compensation-forbids") &&
        kInStep.contains(error->arguments.front()))
        return outcomeOfForbidden(answer, ours);
    const int theirLine = answer.errorClass == "no-program-end" ? 0 : answer.errorLine;
    const int ourLine = error == nullptr ? 0 : error->where.line;
    const Reason reason = ourLine == theirLine ? Reason() : reasonFor(lines, answer, error);
    const bool refused = answer.errorLine != 0 || ourLine != 0;
    const Extent extent = reason.text != nullptr ? reason.extent
                          : refused              ? Extent::oracleBegins
                                                 : Extent::whole;
    const Program& compared = extent == Extent::oursBegins ? ours.upToError : ours.whole;
    std::string why;
    if (!sameSteps(upToError(answer), compared, extent, kListing, why))
        return {"differs", why};
    if (reason.text != nullptr)
        return {reason.text, ""};
    if (ourLine != theirLine) {
        return {"differs", fmt::format("refused at line {} ({}) / {} ({})", theirLine, answer.errorText,
                                       ourLine, error == nullptr ? "" : error->id)};
    }
    if (ourLine == 0)
        return {"agrees", ""};
    return {"refused by both: " + answer.errorText.substr(0, 60), ""};
}

} // namespace proveout::test
