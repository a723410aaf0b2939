// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 vertex;

uniform vec3 shift; // into stock coordinates
uniform mat4 clipFromStock;

void main() {
    gl_Position = clipFromStock * vec4(vertex + shift, 1.0);
}
