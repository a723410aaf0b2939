// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 vertex;
layout(location = 1) in float along; // mm from the start of the path, for dashes
layout(location = 2) in float kind;  // row of the table of line styles

uniform vec3 shift; // of the path's origin in stock coordinates
uniform mat4 clipFromStock;

out float vertexAlong;
out float vertexKind;

void main() {
    vertexAlong = along;
    vertexKind = kind;
    gl_Position = clipFromStock * vec4(vertex + shift, 1.0);
    // The path of a tip lies on the surface it has cut: drawn a hair nearer, it does not flicker.
    gl_Position.z -= 0.0004 * gl_Position.w;
}
