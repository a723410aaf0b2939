// SPDX-License-Identifier: GPL-3.0-or-later
// The light of a workshop: a soft lamp over the viewer's left shoulder, a weak one on his forehead, a bright ceiling, a dark floor. Metal shows
// its surroundings, so the reflected direction looks up a simple room instead of a single highlight.

uniform vec3 lampDirection; // towards the lamp, unit
uniform vec3 upOnScreen;    // the viewer's up, unit
uniform vec4 eye;           // w = 1: the eye's position; w = 0: the direction towards the eye, unit

vec3 towardsEye(vec3 at) { return eye.w > 0.5 ? normalize(eye.xyz - at) : eye.xyz; }

vec3 lit(vec3 albedo, float gloss, vec3 normal, vec3 at) {
    vec3 view = towardsEye(at);
    float lamp = max(dot(normal, lampDirection), 0.0);
    float facing = max(dot(normal, view), 0.0);
    float sky = 0.5 + 0.5 * normal.z;
    vec3 diffuse = albedo * (mix(vec3(0.26, 0.25, 0.25), vec3(0.40, 0.42, 0.45), sky) + 0.46 * lamp + 0.24 * facing);

    vec3 mirrored = reflect(-view, normal);
    float ceiling = smoothstep(-0.85, 0.95, dot(mirrored, upOnScreen) + 0.35 * mirrored.z);
    float spot = max(dot(mirrored, lampDirection), 0.0);
    spot *= spot;
    spot *= spot;
    float glint = spot * spot * spot;
    float grazing = 1.0 - facing;
    grazing *= grazing;
    vec3 room = mix(vec3(0.17, 0.18, 0.20), vec3(0.80, 0.83, 0.86), ceiling) + vec3(0.55, 0.53, 0.50) * glint;
    return mix(diffuse, room, gloss * (0.75 + 0.25 * grazing));
}
