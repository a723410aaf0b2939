// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of the deviations from the part, one for each point of the map, in the pages of heights.glsl without their margin.

uniform sampler2DArray deviations;
uniform sampler2D deviationTiles; // of each tile of 64 × 64 points: 1 if the deviations are those of the heights that are drawn
uniform ivec2 deviationPagePoints;
uniform int deviationPageColumns;
uniform float allowance;
uniform vec2 tolerance; // how much may be missing, and left
uniform vec3 excessAlbedo;
uniform vec3 leftAlbedo;
uniform vec3 exactAlbedo;
uniform vec3 missingAlbedo;
uniform vec3 gougeAlbedo;
uniform float hatchPixels; // from one line to the next

const float kNotJudged = 5e4; // DeviationTexture

float deviationOf(ivec2 point) {
    if (texelFetch(deviationTiles, point / 64, 0).r < 0.5)
        return 2.0 * kNotJudged;
    ivec2 page = point / deviationPagePoints;
    return texelFetch(deviations, ivec3(point - page * deviationPagePoints, page.y * deviationPageColumns + page.x), 0).r;
}

// That of the nearest point; between the points where all around are judged.
float deviationAt(vec2 cells) {
    ivec2 first = clamp(ivec2(cells), ivec2(0), gridPoints - 2);
    vec2 place = clamp(cells - vec2(first), 0.0, 1.0);
    float sw = deviationOf(first);
    float se = deviationOf(first + ivec2(1, 0));
    float nw = deviationOf(first + ivec2(0, 1));
    float ne = deviationOf(first + ivec2(1, 1));
    if (max(max(sw, se), max(nw, ne)) < kNotJudged)
        return mix(mix(sw, se, place.x), mix(nw, ne, place.x), place.y);
    bvec2 far = greaterThan(place, vec2(0.5));
    return far.y ? (far.x ? ne : nw) : (far.x ? se : sw);
}

// The colour at a place; with a = 0 where it is not judged.
vec4 deviationColourAt(vec2 cells) {
    float deviation = deviationAt(cells);
    float off = deviation - allowance;
    float blur = clamp(0.5 * fwidth(off), 1e-6, 0.1 * max(tolerance.x + tolerance.y, 1e-5)); // smooth borders of bands
    float share = off > 0.0 ? off / max(tolerance.y, 1e-6) : -off / max(tolerance.x, 1e-6);
    vec3 within = mix(exactAlbedo, off > 0.0 ? leftAlbedo : missingAlbedo, clamp(share, 0.0, 1.0));
    float line = fract((gl_FragCoord.x + gl_FragCoord.y) / hatchPixels);
    vec3 gouge = gougeAlbedo * mix(1.0, 0.62, smoothstep(0.55, 0.65, line) - smoothstep(0.9, 1.0, line));
    vec3 colour = mix(within, excessAlbedo, smoothstep(-blur, blur, off - tolerance.y));
    colour = mix(colour, gouge, smoothstep(-blur, blur, -off - tolerance.x));
    return vec4(colour, deviation < kNotJudged ? 1.0 : 0.0);
}
