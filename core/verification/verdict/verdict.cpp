// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/verdict/verdict.h"

#include <algorithm>

#include "core/verification/findings/exit_effect.h"

namespace proveout {

const char* name(Verdict verdict) {
    switch (verdict) {
    case Verdict::safe:
        return "safe";
    case Verdict::faults:
        return "faults";
    case Verdict::unverified:
        break;
    }
    return "unverified";
}

Verdict verdictOf(const Diagnostics& findings, std::span<const NotChecked> notChecked) {
    ExitEffect effect = ExitEffect::none;
    for (const Diagnostic& finding : findings)
        effect = worse(effect, exitEffect(finding.severity, finding.unverified));
    if (effect == ExitEffect::faults)
        return Verdict::faults;
    const bool whole = std::ranges::all_of(notChecked, &NotChecked::accepted);
    return whole && effect == ExitEffect::none ? Verdict::safe : Verdict::unverified;
}

} // namespace proveout
