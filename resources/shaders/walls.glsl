// SPDX-License-Identifier: GPL-3.0-or-later
// Where points beside walls stand: on the wall. The place of each tile of 64 × 64 points in layers of 8 × 8 tiles; below 0: it has no wall.

uniform bool hasWalls;
uniform isampler2D wallPlaces;
uniform sampler2DArray wallOffsets;

// How far a point is moved, mm, and 1 where a wall is so near that differences between points are not the slope of the surface.
vec4 wallOffsetOf(ivec2 point) {
    if (!hasWalls)
        return vec4(0.0);
    int place = texelFetch(wallPlaces, point / 64, 0).r;
    if (place < 0)
        return vec4(0.0);
    ivec2 first = 64 * ivec2(place % 8, place / 8 % 8);
    return texelFetch(wallOffsets, ivec3(first + point % 64, place / 64), 0);
}
