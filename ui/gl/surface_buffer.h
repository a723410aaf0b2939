// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

#include "core/decimation/surface/surface.h"
#include "ui/gl/index_buffer.h"
#include "ui/gl/upload_budget.h"

namespace proveout {

/// The triangles of a surface on the GPU, as indices into the lattice. A decimated region has its own list,
/// which is written again only when the pointer to its mesh has changed. A region drawn from the z-map with
/// full borders needs no list: all such regions of one size share a pattern, which the base vertex moves to
/// the right place. Where such a region borders a decimated one, a list of the triangles along its borders
/// matches the polyline, and a smaller pattern fills the inside. All methods need the same context to be
/// current.
class SurfaceBuffer {
public:
    struct Uploaded {
        std::size_t lists = 0;
        std::size_t indices = 0;
        std::size_t bytes = 0;
        bool changed = false; ///< whether any mesh or border has changed
        bool whole = true;    ///< whether the surface is uploaded completely
        bool fits = true;     ///< false: the limit is too small for it, and nothing is drawn
    };
    enum class Part : std::uint8_t { fromZMap, decimated };

    /// IndexBuffer::setLimit().
    void setLimit(std::size_t bytes);
    /// Uploads the surface, or a part of what is still missing; the next call continues. Do not draw before
    /// it is complete. `step`: regions drawn from the z-map have every step-th of their points in each
    /// direction; more than 1 only for a surface without any mesh or polyline, because a neighbour of one
    /// has all points at its border.
    [[nodiscard]] Uploaded update(Gl& gl, const SurfaceSnapshot& surface, const UploadBudget& budget = {},
                                  int step = 1);
    /// At least the bytes that the lists of a surface take.
    [[nodiscard]] static std::size_t bytesFor(const SurfaceSnapshot& surface);
    [[nodiscard]] std::size_t bytes() const { return m_indices.bytes(); } ///< held now
    /// Draws the triangles of one part with the bound program; a vertex array must be bound.
    void draw(Gl& gl, Part part);
    [[nodiscard]] std::size_t triangles(Part part) const {
        return m_triangles[static_cast<std::size_t>(part)];
    }
    void release(Gl& gl);

private:
    struct Region {
        RegionMeshPtr mesh;
        std::array<BorderLinePtr, 4> borders; ///< only for a region drawn from the z-map
        IndexBuffer::Slot slot;
        IndexWidth width = IndexWidth::bits16;
        std::uint32_t count = 0; ///< indices in the slot; 0: drawn only with a pattern, or not drawn
        bool known = false;
    };
    struct Pattern {
        IndexBuffer::Slot slot;
        IndexWidth width = IndexWidth::bits16;
        std::uint32_t count = 0;
    };
    struct DrawList {
        std::vector<GLsizei> counts;
        std::vector<const void*> offsets;
        std::vector<GLint> baseVertices;

        void clear();
        void add(std::uint32_t offset, std::uint32_t count, std::uint32_t baseVertex);
    };

    [[nodiscard]] IndexBuffer::Slot write(Gl& gl, IndexBuffer::Slot slot,
                                          const std::vector<std::uint32_t>& indices, IndexWidth width,
                                          Uploaded& uploaded);
    DrawList& listOf(Part part, IndexWidth width) {
        return m_lists[static_cast<std::size_t>(part)][static_cast<std::size_t>(width)];
    }
    void writeList(Gl& gl, std::size_t index, const std::vector<LatticeTriangle>& triangles,
                   Uploaded& uploaded);
    /// Returns whether the region needed an update.
    bool updateRegion(Gl& gl, const SurfaceSnapshot& surface, std::size_t index, Uploaded& uploaded);
    [[nodiscard]] Pattern pattern(Gl& gl, const IndexRect& points, Uploaded& uploaded);
    void forget();
    /// Begins after the last region of an update that did not come to its end. Stops where there is no room.
    void updateRegions(Gl& gl, const SurfaceSnapshot& surface, const UploadBudget& budget,
                       Uploaded& uploaded);
    [[nodiscard]] std::uint32_t firstPoint(std::size_t region) const;
    void collect(Gl& gl, Uploaded& uploaded);

    RegionGrid m_grid;
    int m_step = 1;
    std::vector<Region> m_regions;
    std::size_t m_resume = 0;
    bool m_collected = false; ///< whether m_lists is up to date
    bool m_restarted = false; ///< m_indices has all bytes of its limit; no update was complete since then
    IndexBuffer m_indices;
    std::map<std::tuple<int, int, int>, Pattern> m_patterns; ///< by width, height, parity of the first point
    std::array<std::array<DrawList, 2>, 2> m_lists;          ///< by part and by width of the indices
    std::array<std::size_t, 2> m_triangles{};
};

} // namespace proveout
