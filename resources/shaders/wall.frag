// SPDX-License-Identifier: GPL-3.0-or-later
// Outside walls and the underside of the stock: flat, each with one normal.

uniform vec2 spacing;
uniform vec3 normal;
uniform float floorHeight;
uniform float stockHeight;
uniform vec3 rawAlbedo;
uniform bool underside;

in vec3 vertexPosition;
out vec4 colour;

void main() {
    if (isCutOut(vertexPosition.xy))
        discard;
    if (underside) {
        // A cell that is cut away to the floor is a hole.
        ivec2 cell = clamp(ivec2(floor(vertexPosition.xy / spacing)), ivec2(0), gridPoints - 2);
        float highest = max(max(heightOf(cell), heightOf(cell + ivec2(1, 0))),
                            max(heightOf(cell + ivec2(0, 1)), heightOf(cell + ivec2(1, 1))));
        if (highest <= floorHeight)
            discard;
    }
    float lift = underside ? 0.9 : mix(0.82, 1.0, vertexPosition.z / stockHeight);
    colour = vec4(lift * lit(rawAlbedo, 0.16, normal, vertexPosition), 1.0);
}
