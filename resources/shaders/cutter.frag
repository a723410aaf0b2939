// SPDX-License-Identifier: GPL-3.0-or-later
uniform float radius;
uniform float opacity;
uniform vec3 fluteAlbedo;
uniform vec3 shankAlbedo;
uniform vec3 holderAlbedo;
uniform float hitPart; // of what is drawn as hit; -1: none
uniform vec3 hitAlbedo;

in vec3 position;
in vec3 local;
in vec3 normal;
flat in float piece; // 0: flutes, 1: shank, 2: holder
out vec4 colour;

void main() {
    // Two flutes, 30 degrees of helix: drawn, not modelled.
    float turns = (atan(local.y, local.x) - local.z * 0.577 / radius) / 3.14159265;
    float groove = abs(fract(turns) - 0.5) * 2.0;
    float flute = mix(0.38, 1.0, smoothstep(0.30, 0.44, groove));
    bool fluted = piece < 0.5;
    vec3 albedo = fluted ? fluteAlbedo : piece < 1.5 ? shankAlbedo : holderAlbedo;
    albedo = abs(piece - hitPart) < 0.5 ? hitAlbedo : albedo;
    colour = vec4(lit(fluted ? albedo * flute : albedo, 0.30, normalize(normal), position), opacity);
}
