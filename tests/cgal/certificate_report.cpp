// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cgal/certificate_report.h"

#include <iomanip>
#include <ostream>

namespace proveout::test {

void printReport(std::ostream& out, const std::vector<CertificateRow>& rows) {
    out << "                               |------------- certified --------------|---- paper to the letter "
           "----|\n"
           "map          region allowance  | faces %  vertical  in STL    nearest  | faces %  vertical  x e  "
           "beyond|\n";
    for (const CertificateRow& row : rows) {
        const auto percent = [&row](std::size_t faces) {
            return 100.0 * static_cast<double>(faces) / static_cast<double>(row.facesFull);
        };
        out << std::left << std::setw(13) << row.map << std::right << std::fixed << std::setw(6) << row.region
            << std::setw(10) << std::setprecision(2) << row.allowance << "  |" << std::setw(8)
            << percent(row.faces) << std::setprecision(5) << std::setw(10) << row.vertical << std::setw(10)
            << row.verticalStl << std::setw(10) << row.nearestStl << " |" << std::setprecision(2)
            << std::setw(8) << percent(row.facesPaper) << std::setprecision(4) << std::setw(10)
            << row.verticalPaper << std::setprecision(0) << std::setw(5) << row.verticalPaper / row.allowance
            << std::setw(8) << row.beyondPaper << " |\n";
    }
    out << "vertical: largest distance of a z-map point from the surface along Z, mm; in STL: the same after "
           "the file\n"
           "was written and read; nearest: to the nearest triangle; x e: in allowances; beyond: z-map "
           "points.\n";
}

} // namespace proveout::test
