// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes of grooves whose walls become round below: the rest in a file, and what is reported as removed,
// against closed formulas, and against those without rims.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>
#include <vector>

#include "core/formats/stl.h"
#include "tests/app/command_line.h"
#include "tests/core/decimation/closed_mesh.h"

namespace proveout {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kWidth = 40;
constexpr double kLength = 30;
constexpr double kHeight = 8;

/// A cutter with a round corner, and how deep it cuts.
struct Groover {
    std::string option;
    double radius;
    double corner;
    double depth;

    /// Of its profile, both sides, mm².
    [[nodiscard]] double area() const { return 2 * (level() * round() + cap() + radius * (depth - round())); }
    /// Of a plunge, mm³.
    [[nodiscard]] double plunge() const {
        const double k = round();
        const double squares = corner * k * k - k * k * k / 3;
        return kPi * (level() * level() * k + 2 * level() * cap() + squares + radius * radius * (depth - k));
    }

private:
    [[nodiscard]] double level() const { return radius - corner; }
    [[nodiscard]] double round() const { return std::min(depth, corner); }
    /// Between the axis of the corner and the corner.
    [[nodiscard]] double cap() const {
        const auto integral = [&](double y) {
            return (y * std::sqrt(corner * corner - y * y) + corner * corner * std::asin(y / corner)) / 2;
        };
        return integral(corner) - integral(corner - round());
    }
};

/// A straight groove, or one around a circle.
struct Path {
    std::string name;
    double angle;  ///< degrees
    double length; ///< or the radius of the circle
    bool isRing = false;

    [[nodiscard]] double volume(const Groover& cutter) const {
        return isRing ? 2 * kPi * length * cutter.area() : length * cutter.area() + cutter.plunge();
    }
    [[nodiscard]] std::string program(double depth) const {
        const double x = isRing ? 19.7 + length : 10.3;
        const double y = isRing ? 14.6 : 8.7;
        const double turn = angle * kPi / 180;
        const std::string way =
            isRing ? fmt::format("G3 X{:.7f} Y{:.7f} I{:.7f} J0", x, y, -length)
                   : fmt::format("X{:.7f} Y{:.7f}", x + length * std::cos(turn), y + length * std::sin(turn));
        return fmt::format("T1 M6\nS9000 M3\nG0 X{:.7f} Y{:.7f} Z5\nG1 Z{} F500\n{}\nG0 Z5\nM30\n", x, y,
                           -depth, way);
    }
};

const std::vector<Groover> kGroovers{
    {"bull:d=8,r=2", 4, 2, 3}, {"bull:d=8,r=1", 4, 1, 4}, {"ball:d=8", 4, 4, 5.5}};
const std::vector<Path> kPaths{
    {"along X", 0, 18}, {"at 17 degrees", 17, 18}, {"at 45 degrees", 45, 17}, {"ring", 0, 8.3, true}};

/// How far a volume may be off whatever it is without rims, which may be right by chance: parts of it.
struct Spacing {
    double mm;
    double share;
};
constexpr std::array<Spacing, 3> kSpacings{{{1, 1.5e-2}, {0.5, 5e-3}, {0.1, 3e-4}}};

class CliRoundWalls : public CommandLine {
protected:
    /// The parts by which the volume in the file and the one that is reported are off.
    std::array<double, 2> errors(const Groover& cutter, const Path& path, double spacing, const char* rims) {
        write("p.nc", path.program(cutter.depth));
        const auto done =
            run(fmt::format("simulate p.nc --stock {}x{}x{} --grid {} --tool 1={} --json --mesh "
                            "full --stl o.stl --rims {}",
                            kWidth, kLength, kHeight, spacing, cutter.option, rims));
        EXPECT_EQ(done.exitCode, 0) << done.err;
        const double exact = path.volume(cutter);
        const double left = test::signedVolume(readStl(folder / "o.stl").value());
        return {(kWidth * kLength * kHeight - left) / exact - 1,
                done.json()["removedMm3"].get<double>() / exact - 1};
    }
};

TEST_F(CliRoundWalls, VolumesAreAtLeastAsGoodAsWithoutRims) {
    double sumOn = 0;
    double sumOff = 0;
    for (const Spacing& spacing : kSpacings) {
        for (const Groover& cutter : kGroovers) {
            for (const Path& path : kPaths) {
                const auto on = errors(cutter, path, spacing.mm, "on");
                const auto off = errors(cutter, path, spacing.mm, "off");
                for (const std::size_t k : {0U, 1U}) {
                    EXPECT_LE(std::abs(on.at(k)), std::max(std::abs(off.at(k)), spacing.share))
                        << cutter.option << ", " << cutter.depth << " deep, " << path.name << ", grid "
                        << spacing.mm << (k == 0 ? ", in the file" : ", reported");
                    sumOn += std::abs(on.at(k)) / spacing.share;
                    sumOff += std::abs(off.at(k)) / spacing.share;
                }
            }
        }
    }
    EXPECT_LT(sumOn, sumOff / 2) << "better in most cases";
}

} // namespace
} // namespace proveout
