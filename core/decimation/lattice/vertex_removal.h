// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/decimation/lattice/lattice_triangulation.h"

namespace proveout {

/// Removes interior vertices one by one: a vertex is removed if the hole left by its triangles can be
/// triangulated again so that all z-map points under it stay within the limit. All triangulations of the hole
/// are considered, including those of a half-edge collapse (a fan from one neighbour).
class VertexRemoval {
public:
    /// `limit` in mm; `extras` are vertices of the outline that may be removed as well. False if it was
    /// stopped.
    bool run(const RegionPatch& patch, float limit, bool surface, std::span<const std::int32_t> extras,
             LatticeTriangulation& mesh, const std::stop_token& stop);
    /// The same for a mesh in which only `seeds`, and vertices near those removed, may have become removable.
    /// Vertices on the sides of the patch in `freeSides` (in the order of kSides) may be removed too.
    bool runFrom(const RegionPatch& patch, float limit, bool surface, std::span<const std::int32_t> seeds,
                 const std::array<bool, 4>& freeSides, LatticeTriangulation& mesh,
                 const std::stop_token& stop);
    [[nodiscard]] bool isRemoved(std::int32_t vertex) const {
        return m_state[static_cast<std::size_t>(vertex)] == State::removed;
    }

private:
    static constexpr std::int32_t kMostNeighbours = 16;
    enum class State : std::uint8_t { fixed, idle, queued, removed };
    struct Neighbour {
        PatchVertex at;
        std::int32_t vertex;
        std::int32_t triangle; ///< between this neighbour and the next
        std::int32_t outside;  ///< twin of the edge to the next
    };
    struct Chord {
        std::int32_t apex; ///< third corner of the triangle on the chord's inner side
        float distance;    ///< of that triangle
    };

    void begin(const RegionPatch& patch, float limit, bool surface, LatticeTriangulation& mesh);
    bool drain(const std::stop_token& stop);
    [[nodiscard]] bool tryRemove(std::int32_t vertex);
    void push(std::int32_t vertex);
    [[nodiscard]] bool gatherStar(std::int32_t vertex);
    [[nodiscard]] bool holdsAtCentre() const;
    [[nodiscard]] bool missesCentre(std::int32_t a, std::int32_t b, std::int32_t c) const;
    [[nodiscard]] bool triangulate(std::int32_t from, std::int32_t to);
    std::int32_t writeTriangles(std::int32_t from, std::int32_t to, std::int32_t& slot);
    [[nodiscard]] std::int32_t area(std::int32_t a, std::int32_t b, std::int32_t c) const;

    const RegionPatch* m_patch = nullptr;
    LatticeTriangulation* m_mesh = nullptr;
    float m_limit = 0;
    bool m_surface = false;
    std::int32_t m_count = 0;
    float m_centreZ = 0;
    bool m_isClosed = true; ///< the star surrounds the vertex completely
    std::array<Neighbour, kMostNeighbours> m_ring;
    std::array<std::array<std::int32_t, kMostNeighbours>, kMostNeighbours> m_turn; ///< cross products about v
    std::array<std::array<Chord, kMostNeighbours>, kMostNeighbours> m_chord;
    std::vector<std::int32_t> m_queue;
    std::vector<State> m_state;
};

} // namespace proveout
