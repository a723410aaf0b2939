// SPDX-License-Identifier: GPL-3.0-or-later
// One triangle over the whole picture, from the vertex number alone.
out float up;

void main() {
    vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    up = corner.y;
    gl_Position = vec4(corner * 2.0 - 1.0, 1.0, 1.0);
}
