// SPDX-License-Identifier: GPL-3.0-or-later
// The table of cutter shapes: one row per shape. Parser, dialogs, help and tests read it.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/cutter/cutter.h"

namespace proveout {

struct ShapeKey {
    const char* key;   ///< in a spec, e.g. "d"
    const char* label; ///< for the user interface; marked with PROVEOUT_TEXT
    const char* unit;  ///< "mm" or "°"
    double minimum;
    double maximum;
    double defaultValue; ///< what a dialog proposes; also the value of an optional key that is omitted
    bool required;
    /// What a dialog proposes for a value that is text; null: the value is a number.
    const char* defaultText = nullptr;
    /// How a text that a dialog leaves empty may look; null: as `defaultText`.
    const char* example = nullptr;
    bool whole = false; ///< only whole numbers

    [[nodiscard]] bool isText() const { return defaultText != nullptr; }
    [[nodiscard]] const char* exampleText() const { return example != nullptr ? example : defaultText; }
};

/// The values that were given for the keys of a shape.
struct ShapeValues {
    std::span<const double> numbers; ///< by key; 0 for one that is text
    std::string_view text;           ///< of the one key of the shape that is text

    [[nodiscard]] double operator[](std::size_t key) const { return numbers[key]; }
};

struct CutterShape {
    const char* key;   ///< in a spec, e.g. "ball"
    const char* label; ///< for the user interface; marked with PROVEOUT_TEXT
    std::span<const ShapeKey> keys;
    /// Makes the profile from the values of `keys`, in the same order. Errors: values that fit no shape
    /// together.
    Result<CutterProfile> (*profile)(const ShapeValues& values);
    bool centreCutting = true; ///< where the key `centre` is not given
};

[[nodiscard]] std::span<const CutterShape> cutterShapes();
/// The row of the shape that a spec names; null where there is none with that name.
[[nodiscard]] const CutterShape* shapeOf(std::string_view spec);

/// Keys that every shape has: flute length `l`, shank diameter `sd`, shank length `sl`, stick-out `so`,
/// `holder`, a text, and those of CuttingData.
[[nodiscard]] std::span<const ShapeKey> commonShapeKeys();
/// All keys of a shape, its own ones first; common ones have the defaults of this shape.
[[nodiscard]] std::vector<ShapeKey> keysOf(const CutterShape& shape);
/// The user-facing name of a key of ToolOrigin::defaults: its label in the shape of the spec, or the label of
/// the shape itself; null if there is no such key. Marked with PROVEOUT_TEXT.
[[nodiscard]] const char* labelOfDefault(std::string_view spec, std::string_view key);

} // namespace proveout
