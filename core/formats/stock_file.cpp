// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/stock_file.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/memory.h"
#include "core/formats/job_json.h"
#include "core/formats/npy_header.h"
#include "core/formats/stock_file_findings.h"
#include "core/formats/stock_position_json.h"
#include "core/formats/stock_rims.h"
#include "core/formats/zip_file.h"
#include "core/formats/zip_reader.h"

namespace proveout {

namespace {

static_assert(std::endian::native == std::endian::little, "heights are written as they lie in memory");

/// 2: the position has separate fields. 3: it may have rims. 4: and unseen ribs and unknown tiles. The least
/// that suffices is written.
constexpr int kSchema = 4;
constexpr int kSchemaOfRims = 3;
constexpr int kSchemaWithoutRims = 2;
constexpr const char* kDescription = "stock.json";
constexpr const char* kHeights = "heights.npy";
constexpr std::string_view kHeightType = "<f4";
constexpr std::size_t kDescriptionLimit = 65536; ///< bytes; a description has a few hundred
constexpr int kDepthLimit = 8;
constexpr double kZip64From = 4e9; ///< size of an entry in bytes

constexpr JsonRange kSize{0, 1e7, true};    ///< mm
constexpr JsonRange kPoints{2, 2147483647}; ///< along a side
constexpr int kMostRims = 2147483647;
constexpr JsonRange kRims{0, kMostRims};

struct Description {
    StockBox stock;
    int nx = 0;
    int ny = 0;
    int rims = 0; ///< rimValues()
    int schema = kSchema;
    double spacing = 1;
    StockProvenance provenance;
};

std::string textOf(const Description& d) {
    nlohmann::ordered_json out;
    out["proveoutStock"] = d.schema;
    writeStockPosition(out, d.stock);
    out["width"] = d.stock.width;
    out["depth"] = d.stock.depth;
    out["height"] = d.stock.height;
    out["spacing"] = d.spacing;
    out["nx"] = d.nx;
    out["ny"] = d.ny;
    if (d.rims > 0)
        out["rims"] = d.rims;
    out["provenance"] = {{"program", d.provenance.program},
                         {"blocks", d.provenance.blocks},
                         {"line", d.provenance.line},
                         {"finished", d.provenance.finished}};
    return out.dump(2) + "\n";
}

tl::unexpected<Diagnostics> broken(const char* entry = kHeights) {
    return failure(stock_finding::kStockFileBroken, {entry});
}

Result<std::string> readDescription(ZipReader& zip) {
    if (zip.nextEntry() != kDescription)
        return failure(stock_finding::kNotAStock);
    std::string text(kDescriptionLimit, '\0');
    text.resize(zip.read(text.data(), text.size()));
    if (!zip.intact())
        return broken(kDescription);
    return text;
}

Result<Description> parse(std::string_view text) {
    const auto document = parseJson(text, kDepthLimit);
    if (!document)
        return tl::unexpected(document.error());
    JsonComplaints complaints;
    JsonFields fields(*document, complaints);
    Description d;
    fields.require({"proveoutStock", "width", "depth", "height", "spacing", "nx", "ny"});
    fields.read("proveoutStock", d.schema, {1, 1e9});
    if (d.schema > kSchema)
        return failure(stock_finding::kStockNewer, {std::to_string(d.schema), std::to_string(kSchema)});
    if (const auto position = readStockPosition(fields))
        d.stock.corner = *position;
    else
        fields.require({setup_field::kMinX.key, setup_field::kMinY.key, setup_field::kTopZ.key});
    fields.read("width", d.stock.width, kSize);
    fields.read("depth", d.stock.depth, kSize);
    fields.read("height", d.stock.height, kSize);
    fields.read("spacing", d.spacing, kSize);
    fields.read("nx", d.nx, kPoints);
    fields.read("ny", d.ny, kPoints);
    fields.read("rims", d.rims, kRims);
    JsonFields provenance = fields.object("provenance");
    provenance.read("program", d.provenance.program);
    double blocks = 0;
    double line = 0;
    provenance.read("blocks", blocks, {0, 1e15});
    provenance.read("line", line, {0, 4e9});
    provenance.read("finished", d.provenance.finished);
    d.provenance.blocks = static_cast<std::uint64_t>(blocks);
    d.provenance.line = static_cast<std::uint32_t>(line);
    if (!complaints.errors.empty())
        return tl::unexpected(complaints.errors.take());
    return d;
}

/// The grid computed from the description must be the one that it states.
Result<Grid> gridOf(const Description& d) {
    auto grid = makeGrid(d.stock, d.spacing);
    if (!grid)
        return grid;
    if (grid->nx != d.nx || grid->ny != d.ny)
        return failure(
            stock_finding::kStockGridDiffers,
            {std::to_string(d.nx), std::to_string(d.ny), std::to_string(grid->nx), std::to_string(grid->ny)});
    if (d.rims > mostRimValues(static_cast<double>(grid->nx) * grid->ny))
        return broken(kRimsEntry);
    // Memory for the heights as they are read, in addition to the map that they become.
    const double limit = static_cast<double>(memoryLimitBytes()) - bytesOfRims(std::size_t(d.rims));
    if (auto fits = checkMemory(d.stock, *grid, limit); !fits)
        return tl::unexpected(std::move(fits.error()));
    return grid;
}

Result<void> readHeader(ZipReader& zip, const Grid& grid) {
    if (zip.nextEntry() != kHeights)
        return broken();
    const std::string expected = npyHeader(grid.ny, grid.nx, kHeightType);
    std::string header(expected.size(), '\0');
    if (zip.read(header.data(), header.size()) != header.size())
        return broken();
    if (header != expected)
        return failure(stock_finding::kStockHeightsForm, {std::to_string(grid.nx), std::to_string(grid.ny)});
    return {};
}

Result<ZMapSnapshot> readHeights(ZipReader& zip, const StockBox& stock, const Grid& grid) {
    if (auto header = readHeader(zip, grid); !header)
        return tl::unexpected(std::move(header.error()));
    ZMap zmap(stock, grid);
    const auto columns = static_cast<std::size_t>(grid.nx);
    std::vector<float> row(columns);
    for (int j = 0; j < grid.ny; ++j) {
        if (zip.read(row.data(), columns * sizeof(float)) != columns * sizeof(float))
            return broken();
        const auto bad =
            std::ranges::find_if(row, [&](float height) { return !(height >= zmap.floor() && height <= 0); });
        if (bad != row.end())
            return failure(stock_finding::kStockHeightBad,
                           {std::to_string(j), std::to_string(bad - row.begin())});
        for (int ti = 0; ti < zmap.tilesX(); ++ti) {
            const int i0 = ti * Tile::kSize;
            Tile& tile = zmap.tileForWriting(static_cast<std::size_t>(j / Tile::kSize * zmap.tilesX() + ti));
            std::copy_n(row.data() + i0, std::min(Tile::kSize, grid.nx - i0), &tile.at(0, j % Tile::kSize));
        }
    }
    if (!zip.intact())
        return broken();
    for (std::size_t index = 0; index < zmap.tileCount(); ++index)
        zmap.tileForWriting(index).refreshMaximum();
    return zmap.snapshot();
}

Result<SavedStockFile> readFrom(ZipReader& zip) {
    const auto text = readDescription(zip);
    if (!text)
        return tl::unexpected(text.error());
    const auto description = parse(*text);
    if (!description)
        return tl::unexpected(description.error());
    const auto grid = gridOf(*description);
    if (!grid)
        return tl::unexpected(grid.error());
    auto zmap = readHeights(zip, description->stock, *grid);
    if (!zmap)
        return tl::unexpected(std::move(zmap.error()));
    if (description->rims > 0) {
        auto rims = readRims(zip, *zmap, static_cast<std::size_t>(description->rims));
        if (!rims)
            return broken(kRimsEntry);
        zmap->setRims(std::move(*rims));
    }
    return SavedStockFile{std::move(*zmap), description->spacing, description->provenance};
}

} // namespace

Result<void> writeStock(const std::filesystem::path& file, const ZMapSnapshot& zmap, double spacing,
                        const StockProvenance& provenance) {
    const Grid& grid = zmap.grid();
    const std::size_t rims = rimValues(zmap.rims());
    const bool hasRims = rims > 0 && rims <= kMostRims;
    std::string text;
    try {
        text = textOf({.stock = zmap.stock(),
                       .nx = grid.nx,
                       .ny = grid.ny,
                       .rims = hasRims ? static_cast<int>(rims) : 0,
                       .schema = !hasRims                   ? kSchemaWithoutRims
                                 : areRimsOnly(zmap.rims()) ? kSchemaOfRims
                                                            : kSchema,
                       .spacing = spacing,
                       .provenance = provenance});
    } catch (const nlohmann::json::type_error&) { // the way in which dump() refuses bytes that are not UTF-8
        return failure(stock_finding::kStockNotUtf8, {}, file.string());
    }
    const double bytes = std::max(4.0 * grid.nx * grid.ny, bytesOfRims(rims));
    ZipFile zip(file, bytes > kZip64From);
    zip.beginEntry(kDescription);
    zip.write(text);
    zip.beginEntry(kHeights);
    zip.write(npyHeader(grid.ny, grid.nx, kHeightType));
    std::vector<float> row(static_cast<std::size_t>(grid.nx));
    for (int j = 0; j < grid.ny && !zip.failed(); ++j) {
        zmap.read({0, j, grid.nx, j + 1}, row);
        zip.write({reinterpret_cast<const char*>(row.data()), row.size() * sizeof(float)});
    }
    if (hasRims)
        writeRims(zip, zmap.rims(), rims);
    return zip.commit();
}

Result<SavedStockFile> readStock(const std::filesystem::path& file) {
    ZipReader zip;
    if (auto opened = zip.open(file); !opened)
        return tl::unexpected(std::move(opened.error()));
    auto saved = readFrom(zip);
    if (!saved) {
        for (Diagnostic& error : saved.error()) {
            error.file = file.string();
            error.where = {}; // it refers to a text within the file
        }
    }
    return saved;
}

} // namespace proveout
