// SPDX-License-Identifier: GPL-3.0-or-later
// A job with a design part for tests: a block, whose top the program faces, 0.3 mm too deep in the right
// half.
#pragma once

#include <QFile>
#include <QString>
#include <QTemporaryDir>

namespace proveout {

struct PartJob {
    QTemporaryDir folder;
    QString withPart = folder.filePath(QStringLiteral("part.proveout"));
    QString withoutPart = folder.filePath(QStringLiteral("plain.proveout"));

    PartJob() {
        // The part: a block of 40 × 30 × 10 mm whose top is at Z-2.
        QByteArray mesh = "solid part\n";
        const auto corner = [](int k) {
            return QByteArray("vertex ") + ((k & 1) != 0 ? "40 " : "0 ") + ((k & 2) != 0 ? "30 " : "0 ") +
                   ((k & 4) != 0 ? "-2\n" : "-10\n");
        };
        constexpr int kFacets[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                        {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
        for (const auto& facet : kFacets)
            mesh += "facet normal 0 0 0\nouter loop\n" + corner(facet[0]) + corner(facet[1]) +
                    corner(facet[2]) + "endloop\nendfacet\n";
        write("part.stl", mesh + "endsolid part\n");
        // Faces the left half to size and the right half 0.3 mm too deep; the last pass at the back is
        // missing.
        write("part.nc", "G21 G90 G17\nT1 M6\nS1000 M3\nG43 H1\nG0 X-12 Y5 Z5\nG1 Z-2 F1000\nG1 X20\n"
                         "Z-2.3\nX52\nG0 Z5\nX-12 Y15\nG1 Z-2\nX20\nZ-2.3\nX52\nG0 Z5\nM30\n");
        const QByteArray job = R"("program":"part.nc","grid":0.5,"tools":{"1":"flat:d=12,l=30"},)"
                               R"("stock":{"width":40,"depth":30,"height":10})";
        write("part.proveout", "{\"proveout\":2," + job + R"(,"part":{"file":"part.stl"}})");
        write("plain.proveout", "{\"proveout\":2," + job + "}");
    }

private:
    void write(const char* name, const QByteArray& content) const {
        QFile file(folder.filePath(QLatin1String(name)));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", name);
    }
};

} // namespace proveout
