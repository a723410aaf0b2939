// SPDX-License-Identifier: GPL-3.0-or-later
// Widens a line to a strip of even pixel width with a soft rim: wide lines are no part of a core profile.
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

uniform vec2 viewportSize;
uniform float width; // pixels

in float vertexAlong[];
in float vertexKind[];
noperspective out float across; // pixels from the middle
out float along;
flat out int kind;

void main() {
    vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
    float nearest = 1e-4;
    if (a.w < nearest && b.w < nearest)
        return;
    if (a.w < nearest)
        a = mix(a, b, (nearest - a.w) / (b.w - a.w));
    if (b.w < nearest)
        b = mix(b, a, (nearest - b.w) / (a.w - b.w));
    vec2 direction = (b.xy / b.w - a.xy / a.w) * viewportSize;
    float pixels = length(direction);
    direction = pixels > 1e-6 ? direction / pixels : vec2(1.0, 0.0);
    float half_ = 0.5 * width + 1.0;
    vec2 aside = vec2(-direction.y, direction.x) * half_ * 2.0 / viewportSize;
    kind = int(vertexKind[1] + 0.5);
    for (int corner = 0; corner < 4; ++corner) {
        bool first = corner < 2;
        vec4 end = first ? a : b;
        float side = (corner & 1) == 0 ? 1.0 : -1.0;
        across = side * half_;
        along = first ? vertexAlong[0] : vertexAlong[1];
        gl_Position = vec4(end.xy + side * aside * end.w, end.zw);
        EmitVertex();
    }
    EndPrimitive();
}
