// SPDX-License-Identifier: GPL-3.0-or-later
// The top surface. Normals come from the full z-map, not from the triangles: decimation never shows in the shading.

uniform vec2 spacing;
uniform vec2 gridSize;     // points along x and y
uniform float stockHeight;
uniform vec4 tint;         // colour and strength
uniform vec3 rawAlbedo;    // skin of the stock that no cutter has touched
uniform vec3 cutAlbedo;

#ifdef WIREFRAME
uniform float regionCells;
uniform vec3 wireColour;
uniform vec3 regionColour;
uniform float lineWidth;
in vec3 position;
noperspective in vec3 edgeDistance;
#else
#define position vertexPosition
in vec3 vertexPosition;
#endif

out vec4 colour;

#ifdef WIREFRAME
vec3 withLines(vec3 shaded) {
    // Triangles of a few pixels would drown the picture in ink: their lines fade.
    vec3 spread = fwidth(edgeDistance);
    float nearest = min(edgeDistance.x, min(edgeDistance.y, edgeDistance.z));
    vec2 cells = position.xy / spacing;
    float cellPixels = 1.0 / max(max(fwidth(cells.x), fwidth(cells.y)), 1e-6);
    float line = 1.0 - smoothstep(0.5 * lineWidth - 0.5, 0.5 * lineWidth + 0.5, nearest);
    shaded = mix(shaded, wireColour, 0.85 * line * clamp(cellPixels / (4.0 * lineWidth), 0.25, 1.0));

    vec2 regions = cells / regionCells;
    vec2 toBorder = abs(fract(regions + 0.5) - 0.5) / max(fwidth(regions), vec2(1e-6));
    vec2 toEdge = min(cells, gridSize - 1.0 - cells) / max(fwidth(cells), vec2(1e-6));
    float border = min(min(toBorder.x, toBorder.y), min(toEdge.x, toEdge.y));
    float regionPixels = cellPixels * regionCells;
    float thick = 1.0 - smoothstep(0.9 * lineWidth - 0.5, 0.9 * lineWidth + 0.5, border);
    return mix(shaded, regionColour, thick * clamp(regionPixels / (10.0 * lineWidth), 0.3, 1.0));
}
#endif

void main() {
#ifdef HOLES
    bool elsewhere = isCutOut(position.xy);
    // Exact: where all three corners stand on the floor, every interpolated value is 0.
    if (elsewhere || position.z <= 0.0)
        discard;
#endif
    // Differences over one cell, centred here: continuous, and sharp where the surface has an edge.
    Surroundings around = surroundingsOf(position.xy / spacing);
    vec2 here = around.here;
    vec2 lo = max(here - 0.5 * around.texel, around.first);
    vec2 hi = min(here + 0.5 * around.texel, around.last);
    float west = heightAt(around, vec2(lo.x, here.y));
    float east = heightAt(around, vec2(hi.x, here.y));
    float south = heightAt(around, vec2(here.x, lo.y));
    float north = heightAt(around, vec2(here.x, hi.y));
    vec2 slope = vec2(east - west, north - south) / ((hi - lo) / around.texel * around.cells * spacing);
    vec3 normal = normalize(vec3(-slope, 1.0));
    // Beside a wall these differences lead across it: the triangle itself is as good there.
    bool besideWall = wallOffsetOf(clamp(ivec2(position.xy / spacing + 0.5), ivec2(0), gridPoints - 1)).w > 0.5;
    if (besideWall)
        normal = normalize(cross(dFdx(position), dFdy(position)));

    // Valleys see less of the room, ridges more; deep pockets a little less again.
    vec2 wide = 1.6 * around.texel;
    float rim = 0.25 * (heightAt(around, here - vec2(wide.x, 0.0)) + heightAt(around, here + vec2(wide.x, 0.0)) +
                        heightAt(around, here - vec2(0.0, wide.y)) + heightAt(around, here + vec2(0.0, wide.y)));
    float hollow = besideWall ? 0.0 : (rim - 0.25 * (west + east + south + north)) / (around.cells * spacing.x);
    float open = clamp(1.0 - 0.55 * hollow, 0.62, 1.16) * mix(0.84, 1.0, position.z / stockHeight);

    float raw = smoothstep(-2e-3, -1e-3, position.z - stockHeight) * step(0.9999, normal.z);
    vec3 albedo = mix(cutAlbedo, rawAlbedo, raw);
    albedo = mix(albedo, tint.rgb, tint.a);
    float gloss = mix(0.46, 0.16, max(raw, tint.a));
#ifdef DEVIATION
    vec4 deviation = deviationColourAt(position.xy / spacing);
    albedo = mix(albedo, deviation.rgb, deviation.a);
    gloss = mix(gloss, 0.06, deviation.a); // so that the colours are those of the legend
#endif
    vec3 shaded = open * lit(albedo, gloss, normal, position);
#ifdef WIREFRAME
    shaded = withLines(shaded);
#endif
    colour = vec4(shaded, 1.0);
}
