// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/stock_position_json.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/formats/job_findings.h"

namespace proveout {

namespace {

constexpr const char* kFormerly = "corner";
constexpr std::array kNames{&setup_field::kMinX, &setup_field::kMinY, &setup_field::kTopZ};

} // namespace

std::optional<Vec3> readStockPosition(JsonFields& fields) {
    const bool named =
        std::ranges::any_of(kNames, [&](const Field* field) { return fields.has(field->key); });
    Vec3 corner(0);
    if (fields.has(kFormerly)) {
        if (named)
            fields.fail(kFormerly, job_finding::kJobFieldPosition, {});
        fields.read(kFormerly, corner, kPosition);
        return corner;
    }
    if (!named)
        return {};
    for (int axis = 0; axis < 3; ++axis) {
        const char* key = kNames[static_cast<std::size_t>(axis)]->key;
        fields.require({key});
        fields.read(key, corner[axis], kPosition);
    }
    return corner;
}

void writeStockPosition(nlohmann::ordered_json& out, const StockBox& stock) {
    out[setup_field::kMinX.key] = stock.corner.x;
    out[setup_field::kMinY.key] = stock.corner.y;
    out[setup_field::kTopZ.key] = stock.topZ();
}

} // namespace proveout
