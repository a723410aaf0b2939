// SPDX-License-Identifier: GPL-3.0-or-later
// In the place of heights.glsl, where the graphics memory does not hold all heights. Of every point there is one height, whatever asks for it,
// so that there is no crack: that of its page, if that page is held; else that of a vertex of a decimated mesh; else a value between the
// coarser points around it, every `coarseStep`-th of the map and the last one.

uniform sampler2DArray heights;    // the pages held
uniform sampler2D coarse;          // the coarser points
uniform isampler2D pageLayers;     // of each page: its layer, or -1
uniform usampler2D vertexHeights;  // PointTable: point and bits of its height
uniform int vertexShift;
uniform ivec2 gridPoints; // of the map
uniform ivec2 pagePoints;
uniform int pageMargin;
uniform int coarseStep;

int layerOf(ivec2 page) { return texelFetch(pageLayers, page, 0).r; }

// A coarser cell: its first corner, and the place in it. The last one may be narrower.
struct CoarseCell {
    ivec2 first;
    vec2 place;
};

CoarseCell coarseCellAt(vec2 cells) {
    CoarseCell cell;
    cell.first = clamp(ivec2(cells), ivec2(0), gridPoints - 2) / coarseStep;
    ivec2 start = cell.first * coarseStep;
    ivec2 width = min(ivec2(coarseStep), gridPoints - 1 - start);
    cell.place = (cells - vec2(start)) / vec2(width);
    return cell;
}

float between(float a, float b, float place) { return a + (b - a) * place; } // exact where a = b: on the floor

float coarseHeightOf(ivec2 point) {
    CoarseCell cell = coarseCellAt(vec2(point));
    ivec2 at = cell.first;
    float south = between(texelFetch(coarse, at, 0).r, texelFetch(coarse, at + ivec2(1, 0), 0).r, cell.place.x);
    float north = between(texelFetch(coarse, at + ivec2(0, 1), 0).r, texelFetch(coarse, at + ivec2(1, 1), 0).r, cell.place.x);
    return between(south, north, cell.place.y);
}

float heightOf(ivec2 point) {
    ivec2 page = point / pagePoints;
    int layer = layerOf(page);
    if (layer >= 0)
        return texelFetch(heights, ivec3(point - page * pagePoints + pageMargin, layer), 0).r;
    const uint factor = 2654435769u; // PointTable::kHashFactor
    const uint none = 0xFFFFFFFFu;
    ivec2 size = textureSize(vertexHeights, 0);
    uint index = uint(point.y * gridPoints.x + point.x);
    for (uint place = (index * factor) >> vertexShift;; ++place) {
        int wrapped = int(place & uint(size.x * size.y - 1));
        uvec2 entry = texelFetch(vertexHeights, ivec2(wrapped % size.x, wrapped / size.x), 0).rg;
        if (entry.x == index)
            return uintBitsToFloat(entry.y);
        if (entry.x == none)
            return coarseHeightOf(point);
    }
}

// The texture around a place between points, in texture coordinates of one page or of the coarser points.
struct Surroundings {
    vec2 here;
    vec2 texel;
    vec2 first; // the map's first and last point
    vec2 last;
    float layer; // -1: the coarser points
    float cells; // from one texel to the next
};

Surroundings surroundingsOf(vec2 cells) {
    ivec2 page = clamp(ivec2(cells + 0.5), ivec2(0), gridPoints - 1) / pagePoints;
    int layer = layerOf(page);
    Surroundings around;
    around.layer = float(layer);
    if (layer >= 0) {
        vec2 origin = vec2(page * pagePoints - pageMargin);
        around.texel = 1.0 / vec2(textureSize(heights, 0).xy);
        around.here = (cells - origin + 0.5) * around.texel;
        around.first = (0.5 - origin) * around.texel;
        around.last = (vec2(gridPoints) - origin - 0.5) * around.texel;
        around.cells = 1.0;
    } else {
        CoarseCell cell = coarseCellAt(cells);
        around.texel = 1.0 / vec2(textureSize(coarse, 0));
        around.here = (vec2(cell.first) + cell.place + 0.5) * around.texel;
        around.first = 0.5 * around.texel;
        around.last = 1.0 - 0.5 * around.texel;
        around.cells = float(coarseStep);
    }
    return around;
}

// Between points; beyond the map's edge as at the edge.
float heightAt(Surroundings around, vec2 place) {
    vec2 inside = clamp(place, around.first, around.last);
    return around.layer < 0.0 ? textureLod(coarse, inside, 0.0).r : textureLod(heights, vec3(inside, around.layer), 0.0).r;
}
