// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a case of the fault table in the workstation's window, runs it, and closes it again.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/faults/fault_cases.h"
#include "tests/ui/window/workstation.h"

namespace proveout {

struct FaultVisit {
    double longestMs = 0;  ///< longest time without processing events
    double computedMs = 0; ///< CPU time of the UI thread in the longest one
    double seconds = 0;    ///< until the program is known or refused and no work is in progress
    bool settled = false;  ///< false: the time limit was reached
    double startBytes = 0;
    double peakBytes = 0;
    std::size_t blocks = 0;
    bool noticed = true;                  ///< whether the change of its file was noticed
    std::vector<std::string> messages;    ///< after opening
    std::vector<std::string> cutMessages; ///< after cutting, with an added tool if it had none
    std::string dialog;                   ///< text of a dialog that appeared and was closed
};

/// Returns the window to the document that it showed before, a sample.
[[nodiscard]] FaultVisit visitFault(Workstation& station, const FaultCase& fault);

} // namespace proveout
