// SPDX-License-Identifier: GPL-3.0-or-later
// Visits every row of the described parameter structs.
#pragma once

#include <optional>
#include <set>
#include <type_traits>

#include "core/base/field.h"
#include "core/simulation/setup/setup_fields.h"

namespace proveout {

/// A visitor of describe() that gives a field another valid value. A type of value that it does not handle
/// does not compile.
struct AnotherValue {
    void operator()(double& value, const Field& field) const {
        value = value == field.maximum ? field.minimum : field.maximum;
    }
    void operator()(int& value, const Field& field) const {
        const auto most = static_cast<int>(field.maximum);
        value = value == most ? static_cast<int>(field.minimum) : most;
    }
    void operator()(bool& value, const Field&) const { value = !value; }
    void operator()(std::optional<int>& value, const Field& field) const {
        value = static_cast<int>(field.maximum);
    }
    void operator()(std::optional<Vec3>& value, const Field& field) const {
        value = Vec3(field.minimum, field.maximum, 0.125);
    }
    void operator()(std::optional<DialectId>& value, const Field&) const { value = DialectId::haas; }
    void operator()(std::set<int>& value, const Field& field) const {
        value = {0, static_cast<int>(field.maximum)};
    }
    void operator()(GridPlace<double, bool> grid, const Field& field) const {
        grid.automatic = false;
        grid.spacing = field.minimum;
    }
    template<class Enumeration>
    requires std::is_enum_v<Enumeration>
    void operator()(Enumeration& value, const Field& field) const {
        value = static_cast<Enumeration>((static_cast<std::size_t>(value) + 1) % field.choices.size());
    }
};

/// Calls `check(params, field)` for every row, with a copy of `params` in which only this row has another
/// value.
template<class Params, class Check>
void eachRowChanged(const Params& params, Check&& check) {
    int rows = 0;
    describe(params, [&rows](const auto&, const Field&) { ++rows; });
    for (int row = 0; row < rows; ++row) {
        Params changed = params;
        Field field{};
        int index = 0;
        describe(changed, [&](auto&& value, const Field& here) {
            if (index++ != row)
                return;
            AnotherValue()(value, here);
            field = here;
        });
        check(changed, field);
    }
}

} // namespace proveout
