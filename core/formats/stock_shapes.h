// SPDX-License-Identifier: GPL-3.0-or-later
// The table of stock shapes: one row per shape. The option --stock, job files, the setup panel, help and
// tests read it; adding a shape takes one row and the function that makes its body.
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

/// The description of a stock; the box of a shape with a body follows from that body, except for its corner.
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
/// The value is the index of a choice.
struct StockChoice {
    std::span<const Choice> choices;
    std::size_t (*get)(const StockSpec& spec);
    void (*set)(StockSpec& spec, std::size_t index);
};

/// The fields that describe a shape. A choice may be missing and is then the first one; all other fields are
/// required.
struct StockField {
    const char* key;   ///< in --stock
    const char* name;  ///< in job files
    const char* label; ///< for the user interface; marked with PROVEOUT_TEXT
    const char* help;  ///< one sentence; marked with PROVEOUT_TEXT
    std::variant<StockLength, StockFile, StockChoice> value;
};

struct StockShapeRow {
    StockKind kind;
    const char* key;
    const char* label;   ///< for the user interface; marked with PROVEOUT_TEXT
    const char* help;    ///< one sentence; marked with PROVEOUT_TEXT
    const char* example; ///< for --stock
    std::span<const StockField> fields;
    Result<std::shared_ptr<const StockBody>> (*make)(const StockSpec& spec); ///< null: a box has no body
};

/// Allowed lengths of a side, mm: above the first, at most the second.
inline constexpr double kLeastStockSide = 0;
inline constexpr double kLargestStockSide = 1e6;

/// In the order of StockKind.
[[nodiscard]] std::span<const StockShapeRow> stockShapes();
[[nodiscard]] const StockShapeRow& rowOf(StockKind kind);

/// Reads "WxDxH", a box, or "SHAPE:key=value,…"; a file name may contain commas. No file is opened: the
/// result has no body yet. Errors: an invalid size, shape, key or value.
[[nodiscard]] Result<StockSpec> parseStock(std::string_view text);
/// A text that parseStock() reads back as the same shape.
[[nodiscard]] std::string stockText(const StockSpec& spec);

/// Makes the body, from its file if it has one, and the box around it: its corner is moved to `corner`, or
/// else the body stays in its own coordinates. Takes as long as reading the file. Errors: those of the file,
/// with its name; an invalid body; memory for the map of a saved stock.
[[nodiscard]] Result<void> makeStock(StockSpec& spec, const std::optional<Vec3>& corner);

} // namespace proveout
