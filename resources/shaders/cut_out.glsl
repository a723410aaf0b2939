// SPDX-License-Identifier: GPL-3.0-or-later
// The rectangle in plan that a detail region draws in the place of this surface.

uniform vec4 cutOut; // from x, y to x, y; nothing is cut out where it is empty

// Both surfaces overlap by a pixel and a half: positions of either are rounded on their own and smoothed pixels are left out as a whole, so that
// an exact seam would show the background.
bool isCutOut(vec2 at) {
    vec2 overlap = 1.5 * fwidth(at);
    return all(greaterThan(at, cutOut.xy + overlap)) && all(lessThan(at, cutOut.zw - overlap));
}
