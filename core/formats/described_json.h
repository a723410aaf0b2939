// SPDX-License-Identifier: GPL-3.0-or-later
// Values of described fields (core/base/field.h) in the JSON of a job: one function for each type of value,
// for all structs of parameters. A type without such a function does not compile. Internal to this library.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <type_traits>

#include "core/base/field.h"
#include "core/base/geometry.h"
#include "core/formats/job_json.h"
#include "core/nc/text/dialect.h"
#include "core/simulation/setup/setup_fields.h"

namespace proveout {

/// A visitor of describe() that reads. A missing field leaves its value unchanged.
struct FieldReader {
    JsonFields& fields;

    void operator()(double& value, const Field& field) const;
    void operator()(int& value, const Field& field) const;
    /// The second of the two choices is `true`.
    void operator()(bool& value, const Field& field) const;
    void operator()(std::optional<int>& value, const Field& field) const;
    void operator()(std::optional<Vec3>& value, const Field& field) const;
    void operator()(std::optional<DialectId>& value, const Field& field) const;
    void operator()(std::set<int>& value, const Field& field) const;
    /// The grid is automatic if the field is missing.
    void operator()(GridPlace<double, bool> grid, const Field& field) const;
    template<class Enumeration>
    requires std::is_enum_v<Enumeration>
    void operator()(Enumeration& value, const Field& field) const {
        auto index = static_cast<std::size_t>(value);
        fields.read(field.key, index, field.choices);
        value = static_cast<Enumeration>(index);
    }
};

/// A visitor of describe() that writes; a value that is not set gets no field.
struct FieldWriter {
    nlohmann::ordered_json& out;

    void operator()(double value, const Field& field) const { out[field.key] = value; }
    void operator()(int value, const Field& field) const { out[field.key] = value; }
    /// The first of the two choices gets no field, because older versions and most controls do not know it.
    void operator()(bool value, const Field& field) const;
    void operator()(const std::optional<int>& value, const Field& field) const;
    void operator()(const std::optional<Vec3>& value, const Field& field) const;
    void operator()(const std::optional<DialectId>& value, const Field& field) const;
    void operator()(const std::set<int>& value, const Field& field) const;
    void operator()(GridPlace<const double, const bool> grid, const Field& field) const;
    template<class Enumeration>
    requires std::is_enum_v<Enumeration>
    void operator()(Enumeration value, const Field& field) const {
        out[field.key] = field.choices[static_cast<std::size_t>(value)].key;
    }
};

} // namespace proveout
