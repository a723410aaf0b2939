// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "core/zmap/zmap.h"

namespace proveout {

/// A tile of one or more checkpoints, plain or packed. Owned by one thread.
class KeptTile {
public:
    explicit KeptTile(std::shared_ptr<const Tile> tile) : m_plain(std::move(tile)) {}

    [[nodiscard]] bool isPacked() const { return !m_packed.empty(); }
    [[nodiscard]] std::size_t bytes() const { return isPacked() ? m_packed.size() : sizeof(Tile); }
    /// Whether it holds this very tile.
    [[nodiscard]] bool isCopyOf(const std::shared_ptr<const Tile>& tile) const {
        return m_plain == tile || m_shown.lock() == tile;
    }
    /// Packs the tile, which saves memory once there is no other owner of the plain one.
    void pack();
    /// The tile; a packed one returns the same object as before as long as that is in use.
    [[nodiscard]] std::shared_ptr<const Tile> tile();

private:
    std::shared_ptr<const Tile> m_plain; ///< null if it is packed
    std::vector<std::byte> m_packed;
    std::weak_ptr<const Tile> m_shown; ///< the plain one of a packed tile
};

} // namespace proveout
