// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec3 topColour;
uniform vec3 bottomColour;

in float up;
out vec4 colour;

void main() {
    // Half a grey level of ordered noise keeps the gradient from showing bands.
    float noise = fract(dot(floor(gl_FragCoord.xy), vec2(0.754877, 0.569840))) - 0.5;
    colour = vec4(mix(bottomColour, topColour, smoothstep(0.0, 1.0, up)) + noise / 255.0, 1.0);
}
