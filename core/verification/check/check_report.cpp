// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/check/check_report.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "core/verification/check/cutter_of.h"
#include "core/verification/findings/check_findings.h"

namespace proveout {

namespace {

constexpr double kSamePlace = 1e-6; ///< mm

bool samePlace(const std::optional<Vec3>& a, const std::optional<Vec3>& b) {
    return a && b ? glm::length(*a - *b) <= kSamePlace : a.has_value() == b.has_value();
}

/// Whether a waiver is about this finding, whatever its count and its cutter.
bool namesOfAnyCutter(const Waiver& waiver, const CheckFinding& finding) {
    return waiver.finding == finding.diagnostic.id && waiver.tool == finding.tool &&
           waiver.values == valuesOf(finding.diagnostic) && samePlace(waiver.place, finding.place);
}

/// A waiver written by hand may spell the cutter as the tool table does.
bool namesCutter(const Waiver& waiver, const CheckFinding& finding) {
    return waiver.cutter.empty() || cutterOf(waiver.cutter, finding.diagnostic.id) == finding.cutter;
}

bool names(const Waiver& waiver, const CheckFinding& finding) {
    return namesOfAnyCutter(waiver, finding) && namesCutter(waiver, finding);
}

/// Why a waiver has no effect.
Diagnostic unusedWaiver(const std::vector<CheckFinding>& findings, const Waiver& waiver) {
    std::vector<Argument> of{waiver.finding, waiver.owner, waiver.reason};
    const auto other = std::ranges::find_if(findings, [&](const CheckFinding& finding) {
        return namesOfAnyCutter(waiver, finding) && !namesCutter(waiver, finding);
    });
    if (other == findings.end())
        return diagnosticOf(check_finding::kWaiverUnused, std::move(of));
    of.insert(of.end(), {std::to_string(waiver.tool), other->cutter, waiver.cutter});
    return diagnosticOf(check_finding::kWaiverOfOtherCutter, std::move(of));
}

void waive(std::vector<CheckFinding>& findings, const Waiver& waiver) {
    std::vector<CheckFinding*> named;
    std::size_t count = 0;
    for (CheckFinding& finding : findings) {
        if (!names(waiver, finding))
            continue;
        named.push_back(&finding);
        count += finding.count;
    }
    if (!named.empty() && count == waiver.count) {
        for (CheckFinding* finding : named)
            finding->waived = waiver;
        return;
    }
    findings.push_back({.diagnostic = unusedWaiver(findings, waiver)});
}

} // namespace

std::string valuesOf(const Diagnostic& diagnostic) {
    std::string values;
    for (const Argument& argument : diagnostic.arguments)
        values += (values.empty() ? "" : "; ") + argument.text();
    return values;
}

Verdict CheckReport::verdict() const {
    Diagnostics diagnostics;
    for (const CheckFinding& finding : findings)
        if (!finding.waived)
            diagnostics.push_back(finding.diagnostic);
    const Verdict verdict = verdictOf(diagnostics, notChecked);
    return programUnverified && verdict == Verdict::safe ? Verdict::unverified : verdict;
}

std::size_t CheckReport::faults() const {
    return static_cast<std::size_t>(std::ranges::count_if(findings, [](const CheckFinding& one) {
        return one.diagnostic.severity == Severity::fault && !one.waived;
    }));
}

CheckReport CheckReport::answered(const IdsWithReasons& accepted, const std::vector<Waiver>& waivers) const {
    CheckReport report = *this;
    for (NotChecked& entry : report.notChecked)
        entry.accept(accepted);
    std::erase_if(report.findings, [](const CheckFinding& one) {
        return hasIdOf(one.diagnostic, check_finding::kWaiverUnused);
    });
    for (CheckFinding& finding : report.findings)
        finding.waived.reset();
    for (const Waiver& waiver : waivers)
        waive(report.findings, waiver);
    return report;
}

Waiver CheckReport::waiverOf(const CheckFinding& finding, std::string reason, std::string owner) const {
    Waiver waiver{.finding = finding.diagnostic.id,
                  .tool = finding.tool,
                  .count = 0,
                  .values = valuesOf(finding.diagnostic),
                  .place = finding.place,
                  .reason = std::move(reason),
                  .owner = std::move(owner),
                  .cutter = finding.cutter};
    for (const CheckFinding& one : findings)
        if (names(waiver, one))
            waiver.count += one.count;
    return waiver;
}

std::vector<CheckFinding> missingFrom(const CheckReport& other, const CheckReport& report) {
    using Key = std::tuple<std::string, int, std::string>;
    const auto keyOf = [](const CheckFinding& one) {
        return Key{one.diagnostic.id, one.tool, message(one.diagnostic)};
    };
    std::map<Key, std::size_t> known;
    for (const CheckFinding& one : other.findings)
        ++known[keyOf(one)];
    std::vector<CheckFinding> missing;
    for (const CheckFinding& one : report.findings)
        if (std::size_t& count = known[keyOf(one)]; count > 0)
            --count;
        else
            missing.push_back(one);
    return missing;
}

CheckChange changeBetween(const CheckReport& before, const CheckReport& after) {
    return {.added = missingFrom(before, after).size(), .gone = missingFrom(after, before).size()};
}

} // namespace proveout
