// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/mutation_seeds.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <set>

#include "core/cutter/shapes.h"
#include "core/formats/job_file.h"
#include "core/formats/npy.h"
#include "core/formats/npy_header.h"
#include "core/formats/stl.h"
#include "core/formats/stock_file.h"
#include "tests/core/cutter/default_spec.h"

namespace proveout::test {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestSeed = 4096; ///< bytes: small files get more relevant hits
constexpr int kSide = 5;                      ///< points per side of the map of a saved stock

std::string bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Small files with one of these extensions below a folder, sorted by name; empty if the folder does not
/// exist.
Seeds filesBelow(const fs::path& folder, const std::set<std::string>& endings) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder, error), end; at != end; at.increment(error))
        if (at->is_regular_file() && endings.contains(at->path().extension().string()) &&
            at->file_size() <= kLargestSeed)
            files.push_back(at->path());
    std::ranges::sort(files);
    Seeds seeds;
    for (const fs::path& file : files)
        seeds.push_back(bytesOf(file));
    return seeds;
}

Seeds& operator+=(Seeds& seeds, Seeds more) {
    std::ranges::move(more, std::back_inserter(seeds));
    return seeds;
}

TriangleMesh boxMesh(const Vec3& size) {
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k)
        mesh.vertices.emplace_back((k & 1) != 0 ? size.x : 0, (k & 2) != 0 ? size.y : 0,
                                   (k & 4) != 0 ? size.z : 0);
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

ZMapSnapshot smallMap() {
    const StockBox stock{{1, 2, 3}, kSide - 1, kSide - 1, 10};
    ZMap zmap(stock, makeGrid(stock, 1).value());
    Tile& tile = zmap.tileForWriting(0);
    for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i)
            tile.at(i, j) = -static_cast<float>(i + j);
    tile.refreshMaximum();
    return zmap.snapshot();
}

} // namespace

Seeds programSeeds(const fs::path& /*folder*/) {
    const fs::path source = PROVEOUT_SOURCE_DIR;
    Seeds seeds = filesBelow(source / "tests/data/nc", {".ngc"});
    seeds += filesBelow(fs::path(PROVEOUT_SHARED_DIR) / "corpus", {".ngc", ".nc", ".tap"});
    return seeds;
}

Seeds stlSeeds(const fs::path& folder) {
    Seeds seeds;
    for (const StlEncoding encoding : {StlEncoding::binary, StlEncoding::ascii}) {
        const fs::path file = folder / "seed.stl";
        static_cast<void>(writeStl(file, boxMesh({40, 30, 20}), encoding));
        seeds.push_back(bytesOf(file));
    }
    std::string line = seeds.back();
    std::ranges::replace(line, '\n', ' ');
    seeds.push_back(line);
    seeds += filesBelow(fs::path(PROVEOUT_SHARED_DIR) / "corpus/faults-stl", {".stl"});
    return seeds;
}

Seeds jobSeeds(const fs::path& folder) {
    Seeds seeds = filesBelow(fs::path(PROVEOUT_SOURCE_DIR) / "resources/samples", {".proveout"});
    Job job;
    job.program = folder / "a.nc";
    job.machine = Machine();
    job.setup.start = Vec3(1, 2, 3);
    seeds.push_back(jobText(folder / "a.proveout", job).value());
    seeds.push_back(R"({"proveout":2,"program":"a.nc","grid":0.5,"stock":{"shape":"cylinder","diameter":20,)"
                    R"("height":10},"tools":{"1":"flat:d=6","2":"drill:d=5,angle=118"},"blockDelete":true})");
    return seeds;
}

Seeds toolTableSeeds(const fs::path& /*folder*/) {
    Seeds seeds;
    std::string all;
    int number = 0;
    for (const CutterShape& shape : cutterShapes()) {
        const std::string row = fmt::format("[[tool]]\nnumber = {}\ncutter = \"{}\"\nsource = \"given\"\n\n",
                                            ++number, defaultSpecOf(shape));
        seeds.push_back(row);
        all += row;
    }
    seeds.push_back(all);
    return seeds;
}

Seeds outlineSeeds(const fs::path& /*folder*/) {
    return {"# plate\n0,0\n100 0\n100,80,0.5\n0 80\n\n# hole\n20;20\n40;20\n40;40 1\n", "0 0 1\n50 0 1\n",
            "0\t0\r\n10\t0\r\n5\t8\r\n"};
}

Seeds savedStockSeeds(const fs::path& folder) {
    const fs::path file = folder / "seed.pvstock";
    static_cast<void>(writeStock(file, smallMap(), 1, {"part.nc", 12, 34, true}));
    return {bytesOf(file)};
}

Seeds stockDescriptionSeeds(const fs::path& /*folder*/) {
    return {fmt::format("{{\n  \"proveoutStock\": 1,\n  \"corner\": [1.0, 2.0, 3.0],\n  \"width\": {0},\n  "
                        "\"depth\": {0},\n  \"height\": 10.0,\n  \"spacing\": 1.0,\n  \"nx\": {1},\n  "
                        "\"ny\": {1},\n  \"provenance\": {{\"program\": \"part.nc\", \"blocks\": 12, "
                        "\"line\": 34, \"finished\": true}}\n}}\n",
                        kSide - 1, kSide)};
}

std::string stockHeights() {
    std::string bytes = npyHeader(kSide, kSide, "<f4");
    bytes.append(kSide * kSide * sizeof(float), '\0');
    return bytes;
}

Seeds npySeeds(const fs::path& folder) {
    NpyArray array{6, 7, {}};
    for (int k = 0; k < array.rows * array.columns; ++k)
        array.values.push_back(k * k % 11);
    const fs::path file = folder / "seed.npy";
    static_cast<void>(writeNpy(file, array));
    return {bytesOf(file)};
}

Seeds optionSeeds(const fs::path& folder) {
    // The files that the seeds refer to.
    std::ofstream(folder / "a.nc") << "G0 X0 Y0 Z5 F100\nG1 Z-1\nX10\n";
    std::ofstream(folder / "a.csv") << outlineSeeds(folder).front();
    std::ofstream(folder / "a.proveout") << jobSeeds(folder).front();
    std::ofstream(folder / "tools.toml") << toolTableSeeds(folder).front();
    static_cast<void>(stlSeeds(folder));
    static_cast<void>(savedStockSeeds(folder));
    return {
        "a.nc\n--stock\n100x80x20\n--stock-origin\n0,0,0\n--grid\n0.5\n--tool\n1=ball:d=11,l=50\n",
        "a.nc\n--stock=cylinder:d=50,h=20\n--grid=auto\n--dialect=fanuc\n--start=0,0,50\n"
        "--start-tool=3\n--block-delete\n--compensation-start=b\n--ignore-m=16,24,25\n",
        "a.nc\n--stock\nstl:file=seed.stl\n--machine\nrapidXY=20000,largestFeed=10000,accelerationXY=2000\n"
        "--region\n16\n--period\n5\n--allowance\n0.05\n--method\nlee\n--no-certify\n",
        "--job\na.proveout\n--tools\ntools.toml\n--method=certified\n--level=surface\n"};
}

} // namespace proveout::test
