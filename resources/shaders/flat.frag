// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec3 flatColour;
out vec4 colour;

void main() {
    colour = vec4(flatColour, 1.0);
}
