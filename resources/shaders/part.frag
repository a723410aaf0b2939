// SPDX-License-Identifier: GPL-3.0-or-later
// The design part, see-through: facets that are seen at a grazing angle are less so, which draws its outline.
uniform vec3 albedo;
uniform float opacity;

in vec3 position;
out vec4 colour;

void main() {
    vec3 view = towardsEye(position);
    vec3 normal = normalize(cross(dFdx(position), dFdy(position)));
    float facing = dot(normal, view);
    normal *= facing < 0.0 ? -1.0 : 1.0;
    float grazing = 1.0 - abs(facing);
    colour = vec4(lit(albedo, 0.05, normal, position), opacity * (1.0 + 1.2 * grazing * grazing));
}
