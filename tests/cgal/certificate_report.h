// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace proveout::test {

/// One line of the report: a map, decimated with and without the certificate. All lengths in mm.
struct CertificateRow {
    std::string map;
    int region = 0;
    double allowance = 0;
    std::size_t facesFull = 0;
    std::size_t faces = 0;  ///< certified
    double vertical = 0;    ///< certified: vertical distance from z-map points to the surface, lattice
                            ///< coordinates
    double verticalStl = 0; ///< certified: the same after the round trip through STL, by CGAL
    double nearestStl = 0;  ///< certified: distance from z-map points to the nearest triangle after the round
                            ///< trip, by CGAL
    std::size_t facesPaper = 0; ///< without the certificate
    double verticalPaper = 0;
    std::size_t beyondPaper = 0; ///< z-map points beyond the allowance
};

void printReport(std::ostream& out, const std::vector<CertificateRow>& rows);

} // namespace proveout::test
