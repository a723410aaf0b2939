// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "core/base/geometry.h"
#include "core/cutter/tool_part.h"

namespace proveout {

enum class PathShown : std::uint8_t { none, nearCutter, whole };
enum class CutterShown : std::uint8_t { hidden, seeThrough, solid };

/// The colours of deviations from the part: those of Okabe and Ito out of tolerance, between which there are
/// pale ones, so that they are distinguishable with every common colour blindness.
struct DeviationColours {
    glm::vec3 excess{0.0f, 0.447f, 0.698f}; ///< more is left than allowed
    glm::vec3 left{0.66f, 0.83f, 0.93f};    ///< as much as allowed
    glm::vec3 exact{0.80f, 0.86f, 0.78f};
    glm::vec3 missing{0.97f, 0.85f, 0.58f}; ///< as much as allowed
    glm::vec3 gouge{0.835f, 0.369f, 0.0f};  ///< more is missing than allowed; hatched, because it is as dark
                                            ///< as `excess`
};

/// The colours of a scene, as screen values without gamma conversion, 0 … 1.
struct SceneColours {
    glm::vec3 backdropTop;
    glm::vec3 backdropBottom;
    glm::vec3 rawStock{0.50f, 0.53f, 0.57f}; ///< raw faces that no cutter has touched
    glm::vec3 cutStock{0.78f, 0.79f, 0.80f};
    glm::vec3 wire{0.09f, 0.11f, 0.14f};
    glm::vec3 regionLine{0.02f, 0.20f, 0.42f};
    glm::vec3 flute{0.93f, 0.72f, 0.34f};
    glm::vec3 shank{0.72f, 0.74f, 0.77f};
    glm::vec3 holder{0.30f, 0.35f, 0.43f};
    glm::vec3 fixture{0.50f, 0.42f, 0.68f};
    glm::vec3 hit{1.0f, 0.20f, 0.15f}; ///< parts of the tool, or a fixture, that touch what they must not
    /// Orange and blue of Okabe and Ito, which are distinguishable with every common colour blindness and in
    /// grey.
    glm::vec3 dirty{1.0f, 0.62f, 0.05f};
    glm::vec3 decimated{0.0f, 0.45f, 0.80f};
    glm::vec3 box{0.80f, 0.30f, 0.60f}; ///< the edge of a detail region
    DeviationColours deviation;
    glm::vec3 part{0.0f, 0.62f, 0.50f}; ///< the design part
    glm::vec3 rapid;
    glm::vec3 feed;
    glm::vec3 arc;
};

[[nodiscard]] inline SceneColours lightColours() {
    SceneColours colours;
    colours.backdropTop = {0.93f, 0.95f, 0.97f};
    colours.backdropBottom = {0.70f, 0.75f, 0.80f};
    colours.rapid = {0.80f, 0.33f, 0.0f};
    colours.feed = {0.0f, 0.36f, 0.68f};
    colours.arc = {0.0f, 0.47f, 0.35f};
    return colours;
}

[[nodiscard]] inline SceneColours darkColours() {
    SceneColours colours;
    colours.backdropTop = {0.22f, 0.25f, 0.29f};
    colours.backdropBottom = {0.08f, 0.09f, 0.11f};
    colours.rapid = {0.95f, 0.60f, 0.10f};
    colours.feed = {0.25f, 0.65f, 0.98f};
    colours.arc = {0.10f, 0.78f, 0.58f};
    return colours;
}

/// A moment in which the tool touches what it must not. Value type.
struct ContactShown {
    Vec3 tip{0};                       ///< of the cutter, program coordinates
    std::optional<ToolPart> part = {}; ///< of the tool, drawn as hit
    std::string fixture = {};          ///< drawn as hit; empty: none

    friend bool operator==(const ContactShown&, const ContactShown&) = default;
};

/// Which parts of a scene are drawn, and how. Value type.
struct SceneOptions {
    bool wireframe = false; ///< triangles and region borders
    bool tint = false;      ///< colours regions drawn from the z-map differently from decimated ones
    bool deviation = false; ///< colours the stock by its deviation from the part, where that is known
    bool part = false;      ///< the design part, see-through
    PathShown path = PathShown::nearCutter;
    bool pathThroughStock = true; ///< shows the part of the path that the stock hides, dimmed; no effect if
                                  ///< `path` is none
    CutterShown cutter = CutterShown::solid;
    bool fixtures = true;
    std::optional<ContactShown> contact = {}; ///< the cutter is drawn there, even if it is hidden otherwise
    SceneColours colours = lightColours();
};

} // namespace proveout
