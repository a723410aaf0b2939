// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/kept_tile.h"

#include "core/zmap/packed_tile.h"

namespace proveout {

void KeptTile::pack() {
    if (isPacked())
        return;
    m_packed = packed(*m_plain);
    m_shown = m_plain;
    m_plain.reset();
}

std::shared_ptr<const Tile> KeptTile::tile() {
    if (m_plain)
        return m_plain;
    if (auto shown = m_shown.lock())
        return shown;
    auto tile = std::make_shared<Tile>();
    unpack(m_packed, *tile);
    m_shown = tile;
    return tile;
}

} // namespace proveout
