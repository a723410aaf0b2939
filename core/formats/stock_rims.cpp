// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/stock_rims.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/formats/npy_header.h"

namespace proveout {

namespace {

constexpr const char* kType = "|V24";
constexpr std::size_t kPortion = 4096; ///< rims in memory at once besides the map

/// What a value says of its edge: beside the sides of a rim.
constexpr auto kLastSides = static_cast<std::uint8_t>(RimSides::low);
constexpr std::uint8_t kUnseenRib = 3;
constexpr std::uint8_t kUnknownTile = 4;

/// A value as it lies in the file.
struct FiledRim {
    std::uint32_t tile;
    std::uint16_t edge;
    std::uint16_t highPlace;
    std::uint16_t lowPlace;
    std::uint8_t sides;
    std::uint8_t unused;
    float top;
    float bottom;
    std::int16_t normalX;
    std::int16_t normalY;

    [[nodiscard]] Rim rim() const {
        return {edge, highPlace, lowPlace, static_cast<RimSides>(sides), top, bottom, normalX, normalY};
    }
    [[nodiscard]] bool isRim() const { return sides <= kLastSides; }
    /// Whether nothing but its edge is given.
    [[nodiscard]] bool isBare() const {
        return highPlace == 0 && lowPlace == 0 && top == 0 && bottom == 0 && normalX == 0 && normalY == 0;
    }
    [[nodiscard]] bool isAfter(const FiledRim& other) const {
        const auto order = [](const FiledRim& one) {
            return std::tuple(one.tile, one.edge, one.isRim() ? kLastSides : one.sides);
        };
        return order(*this) > order(other);
    }
};
static_assert(sizeof(FiledRim) == 24, "without gaps");

FiledRim filed(std::size_t tile, const Rim& rim) {
    return {static_cast<std::uint32_t>(tile),
            rim.edge,
            rim.highPlace,
            rim.lowPlace,
            static_cast<std::uint8_t>(rim.sides),
            0,
            rim.top,
            rim.bottom,
            rim.normalX,
            rim.normalY};
}

FiledRim filed(std::size_t tile, std::uint16_t edge, std::uint8_t sides) {
    return {static_cast<std::uint32_t>(tile), edge, 0, 0, sides, 0, 0, 0, 0, 0};
}

/// In their order.
void addValues(std::size_t tile, const RimTile& rims, std::vector<FiledRim>& values) {
    for (const Rim& rim : rims.rims)
        values.push_back(filed(tile, rim));
    for (const std::uint16_t edge : rims.unseenRibs)
        values.push_back(filed(tile, edge, kUnseenRib));
    if (rims.areUnknown)
        values.push_back(filed(tile, 0, kUnknownTile));
    std::ranges::sort(values, [](const FiledRim& a, const FiledRim& b) { return b.isAfter(a); });
}

std::string headerOf(std::size_t count) {
    return npyHeader(static_cast<int>(count), 1, kType);
}

bool isEdgeOf(const ZMapSnapshot& zmap, const FiledRim& rim) {
    if (rim.tile >= zmap.tileCount())
        return false;
    const RimEdge edge = RimEdge::of(rim.edge);
    const IndexRect rect = zmap.tileRect(rim.tile);
    return edge.i < rect.width() && edge.j < rect.height() &&
           rect.i0 + edge.i + (edge.alongY ? 0 : 1) < zmap.grid().nx &&
           rect.j0 + edge.j + (edge.alongY ? 1 : 0) < zmap.grid().ny;
}

bool isSound(const ZMapSnapshot& zmap, const FiledRim& rim) {
    if (rim.unused != 0)
        return false;
    if (rim.sides == kUnknownTile)
        return rim.tile < zmap.tileCount() && rim.edge == 0 && rim.isBare();
    if (!isEdgeOf(zmap, rim))
        return false;
    if (rim.sides == kUnseenRib)
        return rim.isBare();
    const auto isWithin = [&](float height) { return height >= zmap.floor() && height <= 0; };
    constexpr std::int16_t kNone = std::numeric_limits<std::int16_t>::min(); // turning would not negate it
    return rim.isRim() && isWithin(rim.top) && isWithin(rim.bottom) && rim.normalX != kNone &&
           rim.normalY != kNone;
}

/// The tiles of a map, from values in their order.
class TilesOfRims {
public:
    explicit TilesOfRims(std::size_t tiles) : m_rims(tiles) {}

    void add(const FiledRim& rim) {
        if (rim.tile != m_tile)
            close();
        m_tile = rim.tile;
        if (rim.isRim())
            m_open.rims.push_back(rim.rim());
        else if (rim.sides == kUnseenRib)
            m_open.unseenRibs.push_back(rim.edge);
        else
            m_open.areUnknown = true;
    }
    [[nodiscard]] RimMap take() {
        close();
        return std::move(m_rims);
    }

private:
    void close() {
        if (m_open.empty())
            return;
        m_open.rims.shrink_to_fit();
        m_open.unseenRibs.shrink_to_fit();
        m_rims.edit(m_tile) = std::make_shared<const RimTile>(std::exchange(m_open, {}));
    }

    RimMap m_rims;
    RimTile m_open;
    std::size_t m_tile = 0;
};

} // namespace

std::size_t rimValues(const RimMap& rims) {
    return countOf(rims) + unseenRibs(rims) + unknownTiles(rims);
}

double mostRimValues(double points) {
    return 2 * 2 * points + points; // a rim and a rib on both edges from each point, and what is of a tile
}

bool areRimsOnly(const RimMap& rims) {
    return unseenRibs(rims) == 0 && unknownTiles(rims) == 0;
}

double bytesOfRims(std::size_t count) {
    return static_cast<double>(count) * sizeof(FiledRim);
}

void writeRims(ZipFile& zip, const RimMap& rims, std::size_t count) {
    zip.beginEntry(kRimsEntry);
    zip.write(headerOf(count));
    std::vector<FiledRim> portion;
    for (std::size_t tile = 0; tile < rims.size() && !zip.failed(); ++tile) {
        if (rims[tile] == nullptr)
            continue;
        portion.clear();
        addValues(tile, *rims[tile], portion);
        zip.write({reinterpret_cast<const char*>(portion.data()), portion.size() * sizeof(FiledRim)});
    }
}

std::optional<RimMap> readRims(ZipReader& zip, const ZMapSnapshot& zmap, std::size_t count) {
    const std::string expected = headerOf(count);
    std::string header(expected.size(), '\0');
    if (zip.nextEntry() != kRimsEntry || zip.read(header.data(), header.size()) != header.size() ||
        header != expected)
        return std::nullopt;
    TilesOfRims tiles(zmap.tileCount());
    std::vector<FiledRim> portion;
    std::optional<FiledRim> last;
    for (std::size_t first = 0; first < count; first += portion.size()) {
        portion.resize(std::min(kPortion, count - first));
        const std::size_t bytes = portion.size() * sizeof(FiledRim);
        if (zip.read(portion.data(), bytes) != bytes)
            return std::nullopt;
        for (const FiledRim& rim : portion) {
            if (!isSound(zmap, rim) || (last && !rim.isAfter(*last)))
                return std::nullopt;
            tiles.add(rim);
            last = rim;
        }
    }
    return zip.intact() ? std::optional(tiles.take()) : std::nullopt;
}

} // namespace proveout
