// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/memory_cases.h"

#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <utility>

#include "core/formats/npy.h"
#include "tests/app/measured_run.h"

namespace proveout {

namespace {

std::string simulate(const std::string& program, const std::string& rest) {
    const bool isRound = program == "round.nc";
    return "simulate " + program + " --stock " + (isRound ? "cylinder:d=100,h=20" : "100x100x20") +
           " --tool 1=flat:d=6,l=40 --json " + rest;
}

std::string decimate(const std::string& map, const std::string& rest) {
    return "decimate " + map + " --grid 0.1 --floor 0 --json " + rest;
}

void addFullMeshes(std::vector<MemoryCase>& cases) {
    for (const char* program : {"plain.nc", "hole.nc", "sieve.nc", "round.nc"})
        cases.push_back({simulate(program, "--grid 0.05 --mesh full --stl a.stl")});
    for (const char* grid : {"0.2", "0.1", "0.04"})
        cases.push_back({simulate("hole.nc", fmt::format("--grid {} --mesh full --stl a.stl", grid)),
                         std::string(grid) == "0.1"});
    for (const char* file : {"a.obj", "a.ply", "a.3mf", "a.stl --ascii"}) {
        cases.push_back({simulate("hole.nc", fmt::format("--grid 0.1 --mesh full --export {}", file))});
        cases.push_back({simulate("sieve.nc", fmt::format("--grid 0.1 --mesh full --export {}", file))});
    }
    cases.push_back(
        {simulate("hole.nc", "--grid 0.1 --mesh full --stl a.stl --export a.obj --export a.ply")});
    for (const char* program : {"plain-far.nc", "hole-far.nc"})
        cases.push_back(
            {simulate(program, "--grid 0.1 --stock-origin 10000,10000,0 --mesh full --stl a.stl")});
    for (const char* threads : {"1", "2"})
        cases.push_back(
            {simulate("hole.nc", fmt::format("--grid 0.1 --mesh full --stl a.stl --threads {}", threads))});
}

void addDecimated(std::vector<MemoryCase>& cases) {
    for (const char* program : {"plain.nc", "hole.nc", "sieve.nc", "round.nc"}) {
        for (const char* method : {"certified", "lee", "none"})
            cases.push_back({simulate(program, fmt::format("--grid 0.1 --method {} --stl a.stl", method)),
                             std::string(program) == "sieve.nc" && std::string(method) == "certified"});
        cases.push_back({simulate(program, "--grid 0.2 --method global --stl a.stl")});
    }
    for (const char* file : {"a.obj", "a.ply", "a.3mf"})
        cases.push_back({simulate("sieve.nc", fmt::format("--grid 0.1 --export {}", file))});
    for (const char* method : {"certified", "lee", "none"})
        cases.push_back({simulate("sieve.nc", fmt::format("--grid 0.1 --method {}", method))});
    cases.push_back({simulate("sieve.nc", "--grid 0.1 --allowance 0 --stl a.stl")});
    cases.push_back({simulate("sieve.nc", "--grid 0.1 --stl a.stl --threads 1")});
}

void addRecordsAndBoxes(std::vector<MemoryCase>& cases) {
    for (const char* method : {"certified", "lee", "none"})
        cases.push_back({simulate(
            "sieve.nc", fmt::format("--grid 0.1 --method {} --records a.csv --stl a.stl", method))});
    cases.push_back({simulate("sieve.nc", "--grid 0.1 --period 1 --records a.csv")});
    cases.push_back({simulate("hole.nc", "--grid 0.05 --provenance a.npy --method none")});
    cases.push_back({simulate("hole.nc", "--grid 0.1 --provenance a.npy --stl a.stl --records a.csv"), true});
    cases.push_back({simulate("hole.nc", "--grid 0.1 --provenance a.npy --mesh full --stl a.stl")});
    cases.push_back({simulate("sieve.nc", "--grid 0.05 --method none --zmap a.npy --save-stock a.pvstock")});
    cases.push_back(
        {simulate("hole.nc", "--grid 1 --box 40,40,60,60 --box-spacing 0.02 --box-stl a.stl"), true});
    cases.push_back(
        {simulate("plain.nc", "--grid 1 --box 20,20,60,60 --box-spacing 0.02 --box-heights a.npy")});
    cases.push_back({simulate("hole.nc", "--grid 0.1 --mesh full --stl a.stl --box 40,40,60,60 "
                                         "--box-spacing 0.02 --box-stl b.stl")});
}

/// Maps with many walls between their points.
void addWalled(std::vector<MemoryCase>& cases) {
    for (const char* grid : {"0.2", "0.1"})
        for (const char* more : {"", "--mesh full", "--stl a.stl", "--mesh full --stl a.stl"})
            cases.push_back({simulate("fins.nc", fmt::format("--grid {} {}", grid, more)),
                             std::string(grid) == "0.2" && std::string(more).ends_with("a.stl")});
    cases.push_back({simulate("fins.nc", "--grid 0.1 --save-stock a.pvstock")});
    const std::string pits = "simulate pits.nc --stock 41x41x4 --tool 1=flat:d=0.25,l=4 --json --grid 0.1 ";
    cases.push_back({pits + "--stl a.stl"});
    cases.push_back({pits + "--mesh full --stl a.stl", true});
    cases.push_back(
        {simulate("fins.nc", "--grid 1 --box 40,40,60,60 --box-spacing 0.04 --box-stl a.stl"), true});
}

/// Maps from which nothing can be removed, and maps whose solids consist mostly of walls and pinched
/// vertices.
void addHardMaps(std::vector<MemoryCase>& cases) {
    for (const char* method : {"certified", "lee", "global", "none"})
        cases.push_back(
            {decimate("noise.npy", fmt::format("--allowance 0.001 --method {} --stl a.stl", method)),
             std::string(method) == "lee"});
    for (const char* map : {"ruin.npy", "diamonds.npy", "squares.npy", "islands.npy"})
        for (const char* method : {"certified", "none"})
            cases.push_back({decimate(map, fmt::format("--allowance 0.001 --method {} --stl a.stl", method)),
                             std::string(map) == "diamonds.npy" && std::string(method) == "none"});
    cases.push_back({decimate("diamonds.npy", "--method none --origin 10000,10000 --stl a.stl")});
    cases.push_back({decimate("noise.npy", "--allowance 0.001")});
    cases.push_back({decimate("noise.npy", "--allowance 0.001 --threads 1 --export a.3mf")});
}

std::vector<MemoryCase> allCases() {
    std::vector<MemoryCase> cases;
    addFullMeshes(cases);
    addDecimated(cases);
    addRecordsAndBoxes(cases);
    addWalled(cases);
    addHardMaps(cases);
    return cases;
}

void writeProgram(const std::filesystem::path& file, const std::string& blocks, double x0 = 0) {
    std::ofstream(file) << fmt::format("G21 G90\nT1 M6\nM3 S1000 F1000\nG0 X{0} Y{0} Z5\n{1}G0 Z5\nM30\n",
                                       x0 + 20, blocks);
}

std::string throughHole(double x, double y) {
    return fmt::format("G0 Z1\nX{:.3f} Y{:.3f}\nG1 Z-21\n", x, y);
}

std::string manyHoles() {
    std::string blocks;
    for (int j = 0; j < 10; ++j)
        for (int i = 0; i < 10; ++i)
            blocks += throughHole(9.5 * i + 6, 9.5 * j + 6);
    return blocks;
}

/// Slots aslant with walls of a millimetre between them.
std::string fins() {
    std::string blocks;
    for (int k = -2; k < 14; ++k)
        blocks += fmt::format("G0 Z5\nX-5 Y{0:.3f}\nG1 Z-{1}\nX105 Y{2:.3f}\n", 7.07 * k, 10 + k % 3,
                              7.07 * k + 13.1);
    return blocks;
}

/// A pattern of which each hole has more walls between points than points.
std::string pits() {
    std::string blocks;
    for (int k = 0; k < 10'000; ++k)
        blocks += fmt::format("G0 X{:.3f} Y{:.3f}\nG1 Z-3\nG0 Z1\n", 0.5 + 0.4 * (k % 100) + 0.013 * (k % 7),
                              0.5 + 0.4 * (k / 100) + 0.017 * (k % 5));
    return blocks;
}

void writeMap(const std::filesystem::path& file, int points,
              const std::function<double(int i, int j)>& height) {
    NpyArray map{points, points, {}};
    map.values.reserve(static_cast<std::size_t>(points) * static_cast<std::size_t>(points));
    for (int j = 0; j < points; ++j)
        for (int i = 0; i < points; ++i)
            map.values.push_back(height(i, j));
    if (!writeNpy(file, map))
        throw std::runtime_error("cannot write " + file.string());
}

std::string textOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

} // namespace

const std::vector<MemoryCase>& memoryCases() {
    static const std::vector<MemoryCase> cases = allCases();
    return cases;
}

void writeMemoryInputs(const std::filesystem::path& folder) {
    const std::string pocket = "G1 Z-5\nX80\nY80\nX20\nY20\n";
    for (const auto& [name, x0] : {std::pair{"", 0.0}, {"-far", 10000.0}}) {
        const std::string file = name;
        const std::string shifted = fmt::format("G1 Z-5\nX{0}\nY{0}\nX{1}\nY{1}\n", x0 + 80, x0 + 20);
        writeProgram(folder / ("plain" + file + ".nc"), shifted, x0);
        writeProgram(folder / ("hole" + file + ".nc"), shifted + throughHole(x0 + 50, x0 + 50), x0);
    }
    writeProgram(folder / "round.nc", pocket);
    writeProgram(folder / "fins.nc", fins());
    writeProgram(folder / "pits.nc", pits());
    writeProgram(folder / "sieve.nc", pocket + manyHoles());

    constexpr int kPoints = 701;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> height(1, 5);
    const auto onFloorUnless = [&](bool above) { return above ? height(random) : 0.0; };
    writeMap(folder / "noise.npy", kPoints, [&](int, int) { return height(random); });
    writeMap(folder / "ruin.npy", kPoints, [&](int, int) { return onFloorUnless(random() % 2 == 0); });
    // Of the points with four triangles every other one is above the floor, which leaves diamonds that touch
    // each other at their four corners.
    writeMap(folder / "diamonds.npy", kPoints,
             [&](int i, int j) { return onFloorUnless((i + j) % 2 == 1 && i % 2 == 0); });
    writeMap(folder / "squares.npy", kPoints,
             [&](int i, int j) { return onFloorUnless(i % 2 == 1 && j % 2 == 1 && (i + j) % 4 == 0); });
    writeMap(folder / "islands.npy", kPoints,
             [&](int i, int j) { return onFloorUnless((i + j) % 2 == 1 && random() % 4 != 0); });
}

MemoryRun runForMemory(const std::filesystem::path& program, const std::filesystem::path& folder,
                       const std::string& arguments) {
    std::istringstream words(program.string() + " " + arguments);
    std::vector<std::string> texts{std::istream_iterator<std::string>(words), {}};
    const MeasuredRun measured = runMeasured(std::move(texts), folder);
    MemoryRun run;
    run.seconds = measured.seconds;
    run.exitCode = measured.exitCode;
    run.peakBytes = measured.peakBytes;
    run.errors = textOf(folder / "err.txt");
    const auto json = nlohmann::json::parse(textOf(folder / "out.json"), nullptr, false);
    if (json.is_object())
        run.forecastBytes = json.value("forecastBytes", 0.0);
    return run;
}

double smallestPeakBytes(const std::filesystem::path& program, const std::filesystem::path& folder) {
    return runForMemory(program, folder, simulate("plain.nc", "--grid 2 --stl a.stl")).peakBytes;
}

std::string brokenPromise(const MemoryRun& run, double smallestPeak) {
    if (run.exitCode < 0)
        return "killed";
    if (run.exitCode >= 3)
        return "refused: " + run.errors.substr(0, run.errors.find('\n'));
    if (run.forecastBytes <= 0)
        return "without a forecast";
    if (run.peakBytes - smallestPeak > kMostOfForecast * run.forecastBytes)
        return "beyond its forecast";
    return "";
}

} // namespace proveout
