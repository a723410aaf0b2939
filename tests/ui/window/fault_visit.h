// SPDX-License-Identifier: GPL-3.0-or-later
// A case of the fault table, opened in the workstation's window, gone through and left again.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/faults/fault_cases.h"
#include "tests/ui/window/workstation.h"

namespace proveout {

struct FaultVisit {
    double longestMs = 0;  ///< without a look at events
    double computedMs = 0; ///< of the longest one, by the UI thread itself
    double seconds = 0;    ///< until the program is known, or refused, and nothing is under way
    bool settled = false;  ///< else patience ended
    double startBytes = 0;
    double peakBytes = 0;
    std::size_t blocks = 0;
    bool noticed = true;                  ///< what was done to its file
    std::vector<std::string> messages;    ///< once it is opened
    std::vector<std::string> cutMessages; ///< once it is cut, by a tool where it had none
    std::string dialog;                   ///< the text of one that came up, and was closed
};

/// Leaves the window on the document that it found there, a sample.
[[nodiscard]] FaultVisit visitFault(Workstation& station, const FaultCase& fault);

} // namespace proveout
