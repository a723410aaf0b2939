// SPDX-License-Identifier: GPL-3.0-or-later
// Impossible setups, and damaged or hostile job and stock files.
#include <fmt/format.h>
#include <random>
#include <stdexcept>

#include "core/formats/npy_header.h"
#include "core/formats/zip_file.h"
#include "tests/bench/faults/written_faults.h"

namespace proveout {

namespace {

/// A job; numbers are copied as written.
struct JobText {
    std::string width = "40";
    std::string length = "30";
    std::string minX = "-10";
    std::string minY = "-10";
    std::string grid = "0.5";
    std::string tool = "flat:d=4,l=20";
    std::string program = "top.nc";
    std::string more = {};
};

std::string textOf(const JobText& job) {
    return fmt::format(R"({{"proveout": 2, "program": "{}",
"stock": {{"minX": {}, "minY": {}, "topZ": 0, "width": {}, "depth": {}, "height": 10}},
"grid": {}, "start": [0, 0, 50], "tools": {{"1": "{}"}}{}}}
)",
                       job.program, job.minX, job.minY, job.width, job.length, job.grid, job.tool, job.more);
}

void putJob(FaultWriter& writer, int number, const std::string& name, const JobText& job) {
    writer.put(number, name, ".proveout", textOf(job));
}

/// The same with command-line options, each a separate word.
void putOptions(FaultWriter& writer, int number, const std::string& name, const std::string& stock,
                const std::string& grid) {
    writer.add({.number = number,
                .name = name,
                .file = writer.folder() / "top.nc",
                .window = false,
                .setup = {"--stock", stock, "--grid", grid, "--tool", "1=flat:d=4,l=20"}});
}

void writeGrids(FaultWriter& writer) {
    putJob(writer, 34, "stock-1000km", {.width = "1e9", .length = "1e9", .grid = "1"});
    putOptions(writer, 34, "--stock 1000 km", "1000000000x1000000000x10", "1");
    putJob(writer, 49, "stock-1TB", {.width = "500", .length = "500", .grid = "0.001"});
    putJob(writer, 50, "grid-0", {.grid = "0"});
    putJob(writer, 50, "grid-negative", {.grid = "-1"});
    putJob(writer, 50, "grid-1e-9", {.grid = "1e-9"});
    putJob(writer, 50, "grid-nan", {.grid = "NaN"});
    putJob(writer, 50, "grid-1e999", {.grid = "1e999"});
    putJob(writer, 50, "grid-text", {.grid = "\"fine\""});
    for (const char* grid : {"0", "-1", "nan", "inf", "1e-9"})
        putOptions(writer, 50, std::string("--grid ") + grid, "40x30x10", grid);
    putJob(writer, 51, "points-2^64", {.width = "1e6", .length = "1e6", .grid = "0.000232830643"});
    putJob(writer, 51, "points-1e24", {.width = "1e6", .length = "1e6", .grid = "1e-6"});
}

void writeFits(FaultWriter& writer) {
    putJob(writer, 53, "stock-elsewhere", {.minX = "1000"});
    putJob(writer, 53, "tool-above-stock", {.tool = "flat:d=400,l=20"});
    putJob(writer, 53, "tool-length-0", {.tool = "flat:d=4,l=0"});
    putJob(writer, 53, "corner-above-radius", {.tool = "bull:d=4,r=3,l=20"});
    putJob(writer, 57, "one-cell", {.width = "1", .length = "1", .minX = "2", .minY = "0", .grid = "1"});
    putJob(writer, 57, "flat-stock", {.program = "air.nc"});
    putJob(writer, 57, "all-cut-away", {.tool = "flat:d=400,l=20", .program = "through.nc"});
    putJob(writer, 57, "allowance-10", {.more = R"(, "decimation": {"allowance": 10, "region": 256})"});
}

void writeDamagedJobs(FaultWriter& writer) {
    const std::string good = textOf({.more = R"(, "decimation": {"method": "certified", "period": 5})"});
    writer.put(61, "job-truncated", ".proveout", good.substr(0, good.size() / 2));
    writer.put(61, "job-empty", ".proveout", "");
    writer.put(61, "job-newer", ".proveout", R"({"proveout": 99, "program": "top.nc", "stock": 7})");
    putJob(writer, 61, "job-future-fields", {.more = R"(, "coolant": "flood", "pallets": [1, 2])"});
    std::mt19937 random(61);
    for (int flip = 1; flip <= 8; ++flip) {
        std::string damaged = good;
        char& letter = damaged[random() % damaged.size()];
        letter = static_cast<char>(letter ^ (1 << random() % 8));
        writer.put(61, fmt::format("job-bit-flip-{}", flip), ".proveout", damaged);
    }
    writer.put(63, "json-deep", ".proveout", R"({"proveout": 2, "program": )" + std::string(1'000'000, '['));
    std::string objects = R"({"proveout": 2, "program": "top.nc", "stock": )";
    for (int i = 0; i < 1'000'000; ++i)
        objects += R"({"a":)";
    writer.put(63, "json-deep-objects", ".proveout", objects);
    writer.put(63, "json-string", ".proveout",
               R"({"proveout": 2, "program": ")" + std::string(15'000'000, 'x') + "\"}");
    writer.put(63, "json-17MB", ".proveout",
               R"({"proveout": 2, "program": ")" + std::string(17'000'000, 'x') + "\"}");
}

constexpr const char* kStock = R"({"proveoutStock": 2, "minX": 0, "minY": 0, "topZ": 10, "width": 4,
"depth": 3, "height": 2, "spacing": 1, "nx": 5, "ny": 4})";

void writeArchive(const FaultWriter& writer, const std::string& name,
                  const std::vector<std::pair<std::string, std::string>>& entries) {
    ZipFile zip(writer.folder() / name, false);
    for (const auto& [entry, bytes] : entries) {
        zip.beginEntry(entry.c_str());
        zip.write(bytes);
    }
    if (!zip.commit())
        throw std::runtime_error("cannot write " + name);
}

void writeArchives(FaultWriter& writer) {
    const std::string zeros(20 * sizeof(float), '\0');
    const std::string heights = npyHeader(4, 5, "<f4") + zeros;
    writeArchive(writer, "bomb.pvstock",
                 {{"stock.json", kStock}, {"heights.npy", heights + std::string(200'000'000, '\0')}});
    writeArchive(writer, "dots.pvstock", {{"../stock.json", kStock}, {"../heights.npy", heights}});
    writeArchive(writer, "twice.pvstock",
                 {{"stock.json", kStock}, {"stock.json", kStock}, {"heights.npy", heights}});
    std::vector<std::pair<std::string, std::string>> entries(60'000, {"stock.jsoN", ""});
    entries.insert(entries.end(), {{"stock.json", kStock}, {"heights.npy", heights}});
    writeArchive(writer, "entries.pvstock", entries);
    for (const char* name : {"bomb", "dots", "twice", "entries"})
        writer.putStock(62, std::string("zip-") + name, "file", std::string(name) + ".pvstock");
}

} // namespace

void writeJobFaults(FaultWriter& writer) {
    writer.write("top.nc", "G21 G90\nT1 M6\nG0 X2 Y-5 Z30\nG1 Z-2 F100\nY15\nG0 Z30\nM30\n");
    writer.write("air.nc", "G21 G90\nT1 M6\nG0 X2 Y-5 Z30\nX5\nM30\n");
    writer.write("through.nc", "G21 G90\nT1 M6\nG0 X2 Y-5 Z30\nG1 Z-20 F100\nG0 Z30\nM30\n");
    writeGrids(writer);
    writeFits(writer);
    writeDamagedJobs(writer);
    writeArchives(writer);
}

} // namespace proveout
