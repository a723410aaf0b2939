// SPDX-License-Identifier: GPL-3.0-or-later
// The position of a stock in the JSON of jobs and of saved stocks. Internal to this library.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/geometry.h"
#include "core/formats/job_json.h"
#include "core/simulation/setup/setup_fields.h"
#include "core/zmap/stock.h"

namespace proveout {

inline constexpr JsonRange kPosition{-setup_field::kFarthest, setup_field::kFarthest}; ///< mm

/// The fields minX, minY and topZ; nothing if all are missing. Format 1 has them as one point, "corner",
/// whose Z is the top too; both at once are an error.
[[nodiscard]] std::optional<Vec3> readStockPosition(JsonFields& fields);
void writeStockPosition(nlohmann::ordered_json& out, const StockBox& stock);

} // namespace proveout
