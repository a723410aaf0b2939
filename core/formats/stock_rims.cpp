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

/// A rim as it lies in the file.
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
    [[nodiscard]] bool isAfter(const FiledRim& other) const {
        return std::tie(tile, edge) > std::tie(other.tile, other.edge);
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
    const auto isWithin = [&](float height) { return height >= zmap.floor() && height <= 0; };
    constexpr std::int16_t kNone = std::numeric_limits<std::int16_t>::min(); // turning would not negate it
    return isEdgeOf(zmap, rim) && isWithin(rim.top) && isWithin(rim.bottom) &&
           rim.sides <= static_cast<std::uint8_t>(RimSides::low) && rim.unused == 0 && rim.normalX != kNone &&
           rim.normalY != kNone;
}

/// The tiles of a map, from rims in their order.
class TilesOfRims {
public:
    explicit TilesOfRims(std::size_t tiles) : m_rims(tiles) {}

    void add(const FiledRim& rim) {
        if (rim.tile != m_tile)
            close();
        m_tile = rim.tile;
        m_open.rims.push_back(rim.rim());
    }
    [[nodiscard]] RimMap take() {
        close();
        return std::move(m_rims);
    }

private:
    void close() {
        if (m_open.rims.empty())
            return;
        m_open.rims.shrink_to_fit();
        m_rims.edit(m_tile) = std::make_shared<const RimTile>(std::exchange(m_open, {}));
    }

    RimMap m_rims;
    RimTile m_open;
    std::size_t m_tile = 0;
};

} // namespace

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
        for (const Rim& rim : rims[tile]->rims)
            portion.push_back(filed(tile, rim));
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
