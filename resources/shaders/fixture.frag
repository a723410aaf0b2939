// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec3 albedo;
uniform float hitPart; // of what is drawn as hit; -1: none
uniform vec3 hitAlbedo;

in vec3 position;
in vec3 normal;
flat in float piece;
out vec4 colour;

void main() {
    bool hit = abs(piece - hitPart) < 0.5;
    colour = vec4(lit(hit ? hitAlbedo : albedo, 0.12, normalize(normal), position), 1.0);
}
