// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/explained_differences.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>

#include <fmt/format.h>

#include "tests/core/nc/oracle_comparison.h"

namespace proveout::test {

namespace {

constexpr OracleTolerances kListing{1e-5, 1e-3};

/// What we refuse and LinuxCNC runs, by the id of our message, each with the reason.
struct Stricter {
    const char* id;
    const char* word; ///< in the line that we refuse, in lower case
    const char* reason;
};
constexpr const char* kNoNumber =
    "what is no number stops LinuxCNC as a word and as a value only, not in conditions and functions";
constexpr const char* kSelfAssigned = "a name that the block of its first assignment reads is 0 in LinuxCNC";
constexpr const char* kPolarTwice = "of two polar words with one sign LinuxCNC takes the last";
constexpr const char* kSplineFeed = "LinuxCNC asks for a feed before a spline with G94 only";
constexpr const char* kEndlessDo = "a do without its while runs once in LinuxCNC";
constexpr const char* kLatheCycle = "lathe cycles, and the planes of axes that there are not";
constexpr Stricter kStricter[] = {
    {"number-double-sign", "", "X--1 is refused as a slip; within expressions signs may repeat"},
    {"feed-without-spindle", "",
     "with G95 LinuxCNC waits for a spindle that is stopped; the motion never begins"},
    {"synchronised-spindle", "",
     "with G33 LinuxCNC waits for a spindle whose speed is 0; the motion never begins"},
    {"arc-from-elsewhere", "",
     "an arc that begins elsewhere than the control takes the tool to be has no shape"},
    {"spline-handle", "", "G5 without I and J goes on from any motion in LinuxCNC, whatever its direction"},
    {"arc-turns", "", "more than 1000 turns"},
    {"number-negative", "", "a negative dwell is refused; LinuxCNC refuses that of -1 only"},
    {"number-out-of-range", "", "no number is larger than 1e12"},
    {"pitch", "", "a pitch of 0 or less"},
    {"diameter-mode", "", "diameters are of lathes"},
    {"nurbs-weight", "", "a first control point without weight has a weight of -1 in LinuxCNC"},
    {"nurbs-open", "", "a NURBS without G5.3 is dropped by LinuxCNC without a word"},
    {"no-result", "mod", kNoNumber},
    {"no-result", "**", kNoNumber},
    {"parameter-unset", "#<_shared>=", kSelfAssigned},
    {"parameter-unset", "#<_shared> =", kSelfAssigned},
    {"parameter-unset", "#<own>=", kSelfAssigned},
    {"parameter-unset", "#<own> =", kSelfAssigned},
    {"flow-partner", " do", kEndlessDo},
    {"word-twice", "@", kPolarTwice},
    {"word-twice", "^", kPolarTwice},
    {"feed-missing", "g5", kSplineFeed},
    {"code-unknown", "g71.1", kLatheCycle},
    {"code-unknown", "g72.2", kLatheCycle},
};

/// Our messages about programs that never end.
const std::set<std::string> kEndless{"too-many-steps", "too-many-again", "main-return", "endless-loop",
                                     "loop-without-motion"};

/// Codes of LinuxCNC that we know but do not support.
const std::set<std::string> kNotOfMills{"G17.1", "G18.1", "G19.1", "G70", "G71", "G72", "G76"};

/// Spindle-synchronised motions, and NURBS.
const std::set<std::string> kInStep{"G33", "G33.1", "G5.2", "G5.3"};

/// What LinuxCNC refuses and we run, by its message, each with the reason.
struct Milder {
    const char* text;
    const char* word; ///< in the line that it refuses, in lower case
    const char* reason;
};
constexpr const char* kGivenBack =
    "LinuxCNC computes what a subprogram gives back also where it passes the definition over";
constexpr const char* kNoSuchTool = "a tool that the table does not have is told, but its motions are shown";
constexpr Milder kMilder[] = {
    {"Requested tool -1 not found", "43.2",
     "2.9.0~pre1 has no G43.2 with axis words; its manual and later releases have"},
    {"K word missing", "43.2", "2.9.0~pre1 takes the axis words of G43.2 for those of G33"},
    {"P value not an integer with M19", "19", "turns of the spindle until it is oriented are not simulated"},
    {"Requested tool", "t", kNoSuchTool},
    {"Requested tool", "m61", kNoSuchTool},
    {"Bad character '%'", "%", "one % at the end is told and passed over"},
    {"Calculation resulted in", "return", kGivenBack},
    {"Calculation resulted in", "endsub", kGivenBack},
    {"Attempt to", "return", kGivenBack},
    {"Attempt to", "endsub", kGivenBack},
    {"Argument to", "return", kGivenBack},
    {"Argument to", "endsub", kGivenBack},
    {"Negative argument to sqrt", "return", kGivenBack},
    {"Negative argument to sqrt", "endsub", kGivenBack},
    {"Zero or negative argument to ln", "return", kGivenBack},
    {"Zero or negative argument to ln", "endsub", kGivenBack},
};

/// The reason why only one of them refuses a line, which ends its records.
struct Reason {
    const char* text = nullptr; ///< null: there is none
    Extent extent = Extent::whole;
};

std::string inLowerCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/// Whether a line contains a text; uses the last line if the number is invalid.
bool has(const std::vector<std::string>& lines, int line, const char* text) {
    const auto index = line > 0 ? static_cast<std::size_t>(line) : lines.size();
    return inLowerCase(lines.at(std::min(index, lines.size()) - 1)).find(text) != std::string::npos;
}

Reason stricterAt(const std::vector<std::string>& lines, const Diagnostic& error) {
    const int line = static_cast<int>(error.where.line);
    for (const Stricter& row : kStricter) {
        if (error.id == std::string(row.id) && has(lines, line, row.word))
            return {row.reason, Extent::oursBegins};
    }
    if (error.id == std::string("code-unsupported") && kNotOfMills.contains(error.arguments.front()))
        return {kLatheCycle, Extent::oursBegins};
    return {};
}

Reason milderAt(const std::vector<std::string>& lines, const OracleAnswer& answer) {
    const int line = answer.errorLine;
    for (const Milder& row : kMilder) {
        if (answer.errorText.starts_with(row.text) && has(lines, line, row.word))
            return {row.reason, Extent::oracleBegins};
    }
    return {};
}

/// LinuxCNC refuses some blocks only after executing part of them; that part is not compared.
OracleAnswer upToError(const OracleAnswer& answer) {
    OracleAnswer before = answer;
    while (answer.errorLine > 0 && !before.records.empty() && before.records.back()["l"] == answer.errorLine)
        before.records.pop_back();
    return before;
}

/// For a program that never ends: we must stop at a limit or at M99, and both must agree up to there.
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
    return outcomeOfBeginning(upToError(answer), ours.whole, answer.lost.c_str());
}

/// With compensation, the last motion before our first error waits for the next one.
Outcome outcomeUpToWaiting(const OracleAnswer& answer, const OurAnswer& ours, const char* reason) {
    OracleAnswer beginning = upToError(answer);
    const std::size_t known = ours.upToError.motionCount();
    beginning.records.resize(std::min(beginning.records.size(), known - std::min<std::size_t>(known, 1)));
    return outcomeOfBeginning(beginning, ours.whole, reason);
}

/// LinuxCNC runs G33 and similar codes during compensation, without the spindle, and NURBS as if compensation
/// was off; the motion before depends on them.
Outcome outcomeOfForbidden(const OracleAnswer& answer, const OurAnswer& ours) {
    return outcomeUpToWaiting(
        answer, ours, "LinuxCNC forgets the spindle of G33 and the compensation of NURBS where both meet");
}

/// The reasons for one or both of them, because calls and loops decide which line is reached first.
std::vector<Reason> reasonsFor(const std::vector<std::string>& lines, const OracleAnswer& answer,
                               const OurAnswer& ours) {
    std::vector<Reason> reasons;
    if (const Diagnostic* parting = firstParting(ours.whole); parting != nullptr && isUnlikeControl(*parting))
        reasons.push_back({"we tell that LinuxCNC goes on otherwise", Extent::oursBegins});
    if (const Diagnostic* error = firstError(ours.whole); error != nullptr)
        reasons.push_back(stricterAt(lines, *error));
    if (answer.errorLine != 0)
        reasons.push_back(milderAt(lines, answer));
    std::erase_if(reasons, [](const Reason& reason) { return reason.text == nullptr; });
    return reasons;
}

/// Whether the steps of one of them are the beginning of those of the other.
bool isBeginning(const OracleAnswer& answer, const OurAnswer& ours, Extent extent) {
    std::string why;
    const Program& compared = extent == Extent::oursBegins ? ours.upToError : ours.whole;
    return sameSteps(upToError(answer), compared, extent, kListing, why) ||
           (extent == Extent::oursBegins && answer.compensated &&
            outcomeUpToWaiting(answer, ours, "").why.empty());
}

Outcome outcomeWithoutReason(const OracleAnswer& answer, const OurAnswer& ours) {
    const Diagnostic* error = firstError(ours.whole);
    const int theirLine = answer.errorClass == "no-program-end" ? 0 : answer.errorLine;
    const int ourLine = error == nullptr ? 0 : error->where.line;
    // A motion that waits for the next one is lost if the program has no end.
    const bool waits = answer.errorClass == "no-program-end" && answer.compensated;
    const bool refused = answer.errorLine != 0 || ourLine != 0 || waits;
    std::string why;
    if (!sameSteps(upToError(answer), ours.whole, refused ? Extent::oracleBegins : Extent::whole, kListing,
                   why))
        return {"differs", why};
    if (ourLine != theirLine) {
        return {"differs", fmt::format("refused at line {} ({}) / {} ({})", theirLine, answer.errorText,
                                       ourLine, error == nullptr ? "" : error->id)};
    }
    if (ourLine == 0)
        return {"agrees", ""};
    return {"refused by both: " + answer.errorText.substr(0, 60), ""};
}

} // namespace

Outcome outcomeOf(const std::vector<std::string>& lines, const OracleAnswer& answer, const OurAnswer& ours) {
    if (answer.errorClass == "timeout")
        return outcomeOfEndless(answer, ours);
    const Diagnostic* error = firstError(ours.whole);
    if (error != nullptr && error->id == std::string("compensation-forbids") &&
        kInStep.contains(error->arguments.front()))
        return outcomeOfForbidden(answer, ours);
    for (const Reason& reason : reasonsFor(lines, answer, ours)) {
        if (isBeginning(answer, ours, reason.extent))
            return {reason.text, ""};
    }
    return answer.lost.empty() ? outcomeWithoutReason(answer, ours) : outcomeOfLost(answer, ours);
}

} // namespace proveout::test
