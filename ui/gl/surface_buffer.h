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

/// The triangles of a surface on the graphics side, as indices into the lattice. A decimated region has an
/// own list, written again only when its mesh is another pointer. A region drawn from the z-map with full
/// borders costs nothing: all of one size share one pattern, moved to its place by the base vertex. Where
/// such a region meets a decimated one, an own list of the triangles along its borders meets the polyline,
/// and a smaller pattern fills it. All methods need the same context to be current.
class SurfaceBuffer {
public:
    struct Uploaded {
        std::size_t lists = 0;
        std::size_t indices = 0;
        std::size_t bytes = 0;
        bool changed = false; ///< another mesh or border somewhere
        bool whole = true;    ///< all of the surface is there
    };
    enum class Part : std::uint8_t { fromZMap, decimated };

    /// Brings the surface to the graphics side, or a part of what is not there yet: the next call goes on.
    /// Nothing may be drawn before it is whole.
    [[nodiscard]] Uploaded update(Gl& gl, const SurfaceSnapshot& surface, const UploadBudget& budget = {});
    /// Draws the triangles of one part with the bound program; a vertex array must be bound.
    void draw(Gl& gl, Part part);
    [[nodiscard]] std::size_t triangles(Part part) const {
        return m_triangles[static_cast<std::size_t>(part)];
    }
    void release(Gl& gl);

private:
    struct Region {
        RegionMeshPtr mesh;
        std::array<BorderLinePtr, 4> borders; ///< of a region drawn from the z-map only
        IndexBuffer::Slot slot;
        IndexWidth width = IndexWidth::bits16;
        std::uint32_t count = 0; ///< indices in the slot; 0: drawn with a pattern alone, if at all
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
    /// Whether there was something to do.
    bool updateRegion(Gl& gl, const SurfaceSnapshot& surface, std::size_t index, Uploaded& uploaded);
    const Pattern& pattern(Gl& gl, const IndexRect& points, Uploaded& uploaded);
    [[nodiscard]] std::uint32_t firstPoint(std::size_t region) const;
    void collect(Gl& gl, Uploaded& uploaded);

    RegionGrid m_grid;
    std::vector<Region> m_regions;
    bool m_collected = false; ///< the lists to draw are those of the regions
    IndexBuffer m_indices;
    std::map<std::tuple<int, int, int>, Pattern> m_patterns; ///< by width, height, parity of the first point
    std::array<std::array<DrawList, 2>, 2> m_lists;          ///< by part and width of the indices
    std::array<std::size_t, 2> m_triangles{};
};

} // namespace proveout
