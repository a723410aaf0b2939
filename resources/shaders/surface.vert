// SPDX-License-Identifier: GPL-3.0-or-later
// Every vertex of every mesh is a point of the z-map, so an index is all a vertex needs: index j * columns + i is
// the point (i, j), and the same index plus `points` is the point of the stock's floor below it; beside a wall it is moved to the wall. One formula for
// all meshes gives bit-identical positions, hence no crack between a decimated region and one drawn from the z-map.
// Stock coordinates: mm from the lower-left corner on the stock's floor.

uniform int columns;
uniform int points;
uniform vec2 spacing;
uniform float floorHeight;
uniform mat4 clipFromStock;

out vec3 vertexPosition;
invariant gl_Position; // in all programs: top and walls meet in the same points

void main() {
    bool onFloor = gl_VertexID >= points;
    int index = onFloor ? gl_VertexID - points : gl_VertexID;
    int j = index / columns;
    int i = index - j * columns;
    float height = onFloor ? floorHeight : heightOf(ivec2(i, j));
    vec4 toWall = wallOffsetOf(ivec2(i, j));
    if (!onFloor)
        height += toWall.z;
    vertexPosition = vec3(vec2(i, j) * spacing + toWall.xy, height - floorHeight);
    gl_Position = clipFromStock * vec4(vertexPosition, 1.0);
}
