// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readout/verdict_text.h"

#include <algorithm>

#include <QCoreApplication>

#include "core/verification/findings/check_findings.h"
#include "core/verification/findings/findings.h"
#include "ui/look/diagnostic_text.h"
#include "ui/session/check_hub.h"

namespace proveout {

namespace {

constexpr int kFigures = 4;           ///< of a size
constexpr qsizetype kMostReasons = 6; ///< of findings, in a tooltip

QString say(const char* text) {
    return QCoreApplication::translate("Verdict", text);
}

QString counted(const QLocale& locale, std::size_t count) {
    return locale.toString(static_cast<qulonglong>(count));
}

/// The titles of what was not checked, either accepted or not.
QStringList titles(const CheckReport& report, bool accepted) {
    QStringList all;
    for (const NotChecked& entry : report.notChecked)
        if (entry.accepted == accepted)
            all << coreText(entry.row->title);
    return all;
}

/// The sentences of the findings that have an effect on the verdict, no more than fit a tooltip.
QStringList sentences(const CheckReport& report, bool faults, const QLocale& locale) {
    QStringList all;
    for (const CheckFinding& finding : report.findings) {
        const Diagnostic& diagnostic = finding.diagnostic;
        const bool counts = faults ? diagnostic.severity == Severity::fault
                                   : diagnostic.severity == Severity::error || diagnostic.unverified;
        if (counts && !finding.waived && all.size() < kMostReasons)
            all << placedSentence(finding, locale);
    }
    return all;
}

/// What somebody answers for, and who.
QStringList waived(const CheckReport& report) {
    QStringList all;
    for (const CheckFinding& finding : report.findings)
        if (finding.waived)
            all << QStringLiteral("%1 (%2)").arg(coreText(findingTitle(finding.diagnostic.id)),
                                                 QString::fromStdString(finding.waived->owner));
    all.removeDuplicates();
    return all;
}

QStringList reasonsOf(const CheckReport& report, const QLocale& locale) {
    const Verdict verdict = report.verdict();
    QStringList reasons;
    if (verdict != Verdict::safe)
        reasons = sentences(report, verdict == Verdict::faults, locale);
    const QStringList left = titles(report, false);
    const QStringList accepted = titles(report, true);
    if (verdict == Verdict::safe)
        reasons << say(QT_TRANSLATE_NOOP("Verdict", "The whole program was checked; no faults were found."));
    if (verdict == Verdict::unverified && !left.isEmpty())
        reasons << say(QT_TRANSLATE_NOOP("Verdict", "Not checked: %1.")).arg(left.join(QStringLiteral(", ")));
    if (verdict != Verdict::faults && !accepted.isEmpty())
        reasons << say(QT_TRANSLATE_NOOP("Verdict", "Accepted without a check: %1."))
                       .arg(accepted.join(QStringLiteral(", ")));
    if (const QStringList all = waived(report); !all.isEmpty())
        reasons << say(QT_TRANSLATE_NOOP("Verdict", "Waived: %1.")).arg(all.join(QStringLiteral(", ")));
    return reasons;
}

} // namespace

VerdictState verdictState(const CheckHub& check) {
    if (!check.refusal().empty())
        return VerdictState::refused;
    if (!check.report())
        return check.progress() ? VerdictState::checking : VerdictState::none;
    switch (check.report()->verdict()) {
    case Verdict::safe:
        return VerdictState::safe;
    case Verdict::faults:
        return VerdictState::faults;
    case Verdict::unverified:
        break;
    }
    return VerdictState::unverified;
}

QString verdictText(const CheckHub& check, const QLocale& locale) {
    switch (verdictState(check)) {
    case VerdictState::none:
        break;
    case VerdictState::checking:
        return say(QT_TRANSLATE_NOOP("Verdict", "Checking… %1 %"))
            .arg(locale.toString(static_cast<int>(100 * check.progress().value_or(0))));
    case VerdictState::safe:
        return say(QT_TRANSLATE_NOOP("Verdict", "SAFE"));
    case VerdictState::faults:
        return say(QT_TRANSLATE_NOOP("Verdict", "FAULTS %1")).arg(counted(locale, check.report()->faults()));
    case VerdictState::unverified:
        return say(QT_TRANSLATE_NOOP("Verdict", "UNVERIFIED"));
    case VerdictState::refused:
        const Diagnostic& reason = check.refusal().front();
        if (hasIdOf(reason, check_finding::kCheckNeedsMemory))
            return say(QT_TRANSLATE_NOOP("Verdict", "Not checked: needs %1"))
                .arg(figuresText(reason.arguments.front()));
        return say(QT_TRANSLATE_NOOP("Verdict", "Not checked"));
    }
    return {};
}

QStringList verdictReasons(const CheckHub& check, const QLocale& locale) {
    if (!check.refusal().empty()) {
        const Diagnostic& reason = check.refusal().front();
        QStringList reasons{sentence(reason)};
        if (!hint(reason).isEmpty())
            reasons << hint(reason);
        return reasons;
    }
    if (check.report())
        return reasonsOf(*check.report(), locale);
    if (check.progress())
        return {say(QT_TRANSLATE_NOOP("Verdict", "The whole program is being checked in the background."))};
    return {};
}

QString placedSentence(const CheckFinding& finding, const QLocale& locale) {
    const int line = finding.diagnostic.where.line;
    const QString text = sentence(finding.diagnostic);
    if (finding.block > 0)
        return say(QT_TRANSLATE_NOOP("Verdict", "Line %1, block %2: %3"))
            .arg(locale.toString(line), counted(locale, finding.block), text);
    return line > 0 ? say(QT_TRANSLATE_NOOP("Verdict", "Line %1: %2")).arg(locale.toString(line), text)
                    : text;
}

QString sizeText(const CheckFinding& finding, const QLocale& locale) {
    if (*finding.unit == '\0')
        return {};
    return QStringLiteral("%1 %2").arg(locale.toString(finding.value, 'g', kFigures),
                                       QString::fromUtf8(finding.unit));
}

} // namespace proveout
