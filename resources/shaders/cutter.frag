// SPDX-License-Identifier: GPL-3.0-or-later
uniform float radius;
uniform float opacity;
uniform vec3 fluteAlbedo;
uniform vec3 shankAlbedo;

in vec3 position;
in vec3 local;
in vec3 normal;
in float shank;
out vec4 colour;

void main() {
    // Two flutes, 30 degrees of helix: drawn, not modelled.
    float turns = (atan(local.y, local.x) - local.z * 0.577 / radius) / 3.14159265;
    float groove = abs(fract(turns) - 0.5) * 2.0;
    float flute = smoothstep(0.30, 0.44, groove);
    vec3 albedo = mix(fluteAlbedo * mix(0.38, 1.0, flute), shankAlbedo, step(0.5, shank));
    colour = vec4(lit(albedo, 0.30, normalize(normal), position), opacity);
}
