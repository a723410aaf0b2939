// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 vertex;   // mm from the tip
layout(location = 1) in vec3 direction;
layout(location = 2) in float part;    // 0: fluted, 1: shank

uniform vec3 tip; // in stock coordinates
uniform mat4 clipFromStock;

out vec3 position;
out vec3 local;
out vec3 normal;
out float shank;

void main() {
    local = vertex;
    position = vertex + tip;
    normal = direction;
    shank = part;
    gl_Position = clipFromStock * vec4(position, 1.0);
}
