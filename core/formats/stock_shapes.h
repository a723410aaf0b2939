// SPDX-License-Identifier: GPL-3.0-or-later
// The table of stock shapes: one row a shape. The option --stock, job files, the set-up panel, help and tests
// read it; adding a shape is one row and what makes its body.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/diagnostic.h"
#include "core/base/field.h"
#include "core/zmap/stock_shape.h"

namespace proveout {

/// A stock as it is described; the box of a shape with a body follows from that body, but for its corner.
struct StockSpec {
    StockBox box;
    StockShape shape;

    friend bool operator==(const StockSpec&, const StockSpec&) = default;
};

struct StockLength {
    double (*get)(const StockSpec& spec);
    void (*set)(StockSpec& spec, double length);
};
struct StockFile {
    const char* filter; ///< for a dialog, e.g. "*.stl"
};
/// Its value is the index of a choice.
struct StockChoice {
    std::span<const Choice> choices;
    std::size_t (*get)(const StockSpec& spec);
    void (*set)(StockSpec& spec, std::size_t index);
};

/// What a shape is described by. A choice may be left out and is then the first one; all else is required.
struct StockField {
    const char* key;   ///< of --stock
    const char* name;  ///< in job files
    const char* label; ///< for people; marked with PROVEOUT_TEXT
    const char* help;  ///< one sentence; marked with PROVEOUT_TEXT
    std::variant<StockLength, StockFile, StockChoice> value;
};

struct StockShapeRow {
    StockKind kind;
    const char* key;
    const char* label;   ///< for people; marked with PROVEOUT_TEXT
    const char* help;    ///< one sentence; marked with PROVEOUT_TEXT
    const char* example; ///< of --stock
    std::span<const StockField> fields;
    Result<std::shared_ptr<const StockBody>> (*make)(const StockSpec& spec); ///< null: a box has no body
};

/// Lengths that a side may have, mm: above the first, at most the second.
inline constexpr double kLeastStockSide = 0;
inline constexpr double kLargestStockSide = 1e6;

/// In the order of StockKind.
[[nodiscard]] std::span<const StockShapeRow> stockShapes();
[[nodiscard]] const StockShapeRow& rowOf(StockKind kind);

/// Reads "WxDxH", a box, or "SHAPE:key=value,…"; a file name may hold commas. No file is opened: the result
/// has no body yet. Errors: a size, a shape, a key or a value that cannot be.
[[nodiscard]] Result<StockSpec> parseStock(std::string_view text);
/// What parseStock() reads back as the same shape.
[[nodiscard]] std::string stockText(const StockSpec& spec);

/// Makes the body, from its file where it has one, and the box round it: its corner is moved to `corner`, or
/// is where the body lies by itself. Takes as long as reading the file. Errors: those of the file, with its
/// name; a body that cannot be; memory for the map of a saved stock.
[[nodiscard]] Result<void> makeStock(StockSpec& spec, const std::optional<Vec3>& corner);

} // namespace proveout
