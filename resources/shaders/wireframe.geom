// SPDX-License-Identifier: GPL-3.0-or-later
// Hands each corner its distances, in pixels, to the three edges, so that the fragments can draw the edges with
// smooth lines of even width and without a second pass that would fight with the first one's depth.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform vec2 viewportSize;

in vec3 vertexPosition[];
out vec3 position;
noperspective out vec3 edgeDistance;

vec2 pixel(int corner) { return 0.5 * viewportSize * gl_in[corner].gl_Position.xy / gl_in[corner].gl_Position.w; }

void main() {
    vec2 a = pixel(0), b = pixel(1), c = pixel(2);
    float area = abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    vec3 heightOver = area / max(vec3(distance(b, c), distance(c, a), distance(a, b)), vec3(1e-6));
    for (int corner = 0; corner < 3; ++corner) {
        position = vertexPosition[corner];
        edgeDistance = vec3(0.0);
        edgeDistance[corner] = heightOver[corner];
        gl_Position = gl_in[corner].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
