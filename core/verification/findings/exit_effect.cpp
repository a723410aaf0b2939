// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/findings/exit_effect.h"

namespace proveout {

namespace {

int rank(ExitEffect effect) {
    switch (effect) {
    case ExitEffect::none:
        return 0;
    case ExitEffect::unverified:
        return 1;
    case ExitEffect::faults:
        return 2;
    case ExitEffect::unusable:
        break;
    }
    return 3;
}

} // namespace

ExitEffect exitEffect(Severity severity, bool unverified) {
    if (severity == Severity::fault)
        return ExitEffect::faults;
    return unverified || severity == Severity::error ? ExitEffect::unverified : ExitEffect::none;
}

ExitEffect exitEffect(const FindingTable& table, const FindingRow& row) {
    return table.refusesInput && row.severity == Severity::error ? ExitEffect::unusable
                                                                 : exitEffect(row.severity, row.unverified);
}

ExitEffect worse(ExitEffect one, ExitEffect other) {
    return rank(one) < rank(other) ? other : one;
}

} // namespace proveout
