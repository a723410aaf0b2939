// SPDX-License-Identifier: GPL-3.0-or-later
uniform float width;
uniform float pixelsPerMm;
uniform vec4 colours[3]; // by kind: rapid, feed, arc
uniform vec3 dashes;     // pixels of one dash and its gap, by kind; 0: solid

noperspective in float across;
in float along;
flat in int kind;
out vec4 colour;

void main() {
    float alpha = clamp(0.5 * width + 0.5 - abs(across), 0.0, 1.0);
    float period = kind == 0 ? dashes.x : kind == 1 ? dashes.y : dashes.z;
    if (period > 0.0)
        alpha *= step(fract(along * pixelsPerMm / period), 0.6);
    if (alpha <= 0.0)
        discard;
    colour = colours[kind];
    colour.a *= alpha;
}
