// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a check as one HTML file that needs no network.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace proveout {

/// What the page shows beside its numbers. Empty: not there.
struct ReportPictures {
    std::string stockPng;     ///< from above
    std::string deviationPng; ///< the same, in the colours of the deviations
    std::string glb;          ///< the part in 3D
    double glbErrorMm = 0;    ///< how far it is from the map at most
};

struct ReportHead {
    std::string title;     ///< of the program
    std::string company;   ///< may be empty
    std::string generator; ///< program and version
    std::string date;      ///< as it is to be shown
};

/// `checked`: the object of `check --json`; all numbers on the page are in it, as `data` elements with the
/// JSON pointer of each. Equal inputs give equal bytes.
[[nodiscard]] std::string reportPage(const nlohmann::ordered_json& checked, const ReportHead& head,
                                     const ReportPictures& pictures);

} // namespace proveout
