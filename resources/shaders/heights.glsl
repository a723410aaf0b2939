// SPDX-License-Identifier: GPL-3.0-or-later
// The heights of the z-map, relative to the stock's top. A map with more points along a side than a texture may have is divided into pages, which
// are layers of one texture: each holds `pagePoints` of the map's points and, around them, a margin of its neighbours'.

uniform sampler2DArray heights;
uniform ivec2 gridPoints; // of the map
uniform ivec2 pagePoints;
uniform int pageColumns;
uniform int pageMargin;

float heightOf(ivec2 point) {
    ivec2 page = point / pagePoints;
    return texelFetch(heights, ivec3(point - page * pagePoints + pageMargin, page.y * pageColumns + page.x), 0).r;
}

// The texture around a place between points, in texture coordinates of one page.
struct Surroundings {
    vec2 here;
    vec2 texel;
    vec2 first; // the map's first and last point
    vec2 last;
    float layer;
    float cells; // from one texel to the next
};

Surroundings surroundingsOf(vec2 cells) {
    ivec2 page = clamp(ivec2(cells + 0.5), ivec2(0), gridPoints - 1) / pagePoints;
    vec2 origin = vec2(page * pagePoints - pageMargin);
    Surroundings around;
    around.texel = 1.0 / vec2(textureSize(heights, 0).xy);
    around.here = (cells - origin + 0.5) * around.texel;
    around.first = (0.5 - origin) * around.texel;
    around.last = (vec2(gridPoints) - origin - 0.5) * around.texel;
    around.layer = float(page.y * pageColumns + page.x);
    around.cells = 1.0;
    return around;
}

// Between points; beyond the map's edge as at the edge.
float heightAt(Surroundings around, vec2 place) {
    return texture(heights, vec3(clamp(place, around.first, around.last), around.layer)).r;
}
