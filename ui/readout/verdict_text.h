// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on the program in words. Thread: UI.
#pragma once

#include <cstdint>

#include <QLocale>
#include <QString>
#include <QStringList>

#include "core/verification/check/check_report.h"

namespace proveout {

class CheckHub;

enum class VerdictState : std::uint8_t {
    none,       ///< no program is open, or the check is off
    checking,   ///< the result is awaited
    safe,       ///< as Verdict
    faults,     ///< as Verdict
    unverified, ///< as Verdict
    refused,    ///< the program cannot be checked
};
[[nodiscard]] VerdictState verdictState(const CheckHub& check);

/// "SAFE", "FAULTS 3", "Checking… 43 %", "Not checked: needs 1.2 GB"; empty if there is none.
[[nodiscard]] QString verdictText(const CheckHub& check, const QLocale& locale);

/// The reasons for it: the first fault, what leaves it unverified, or what was accepted. One line each, plain
/// text.
[[nodiscard]] QStringList verdictReasons(const CheckHub& check, const QLocale& locale);

/// "Line 7, block 4: Rapid move cuts stock (2 mm deep)."
[[nodiscard]] QString placedSentence(const CheckFinding& finding, const QLocale& locale);

/// "2.15 mm", or empty without a value.
[[nodiscard]] QString sizeText(const CheckFinding& finding, const QLocale& locale);

} // namespace proveout
