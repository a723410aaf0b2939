// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 vertex; // mm
layout(location = 1) in vec3 direction;
layout(location = 2) in float part;

uniform vec3 shift; // into stock coordinates
uniform mat4 clipFromStock;

out vec3 position;
out vec3 local;
out vec3 normal;
flat out float piece;

void main() {
    local = vertex;
    position = vertex + shift;
    normal = direction;
    piece = part;
    gl_Position = clipFromStock * vec4(position, 1.0);
}
