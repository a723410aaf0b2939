// SPDX-License-Identifier: GPL-3.0-or-later
// Options for described fields (core/base/field.h): one function per type of value, for all parameter
// structs. A type without a function does not compile.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/base/diagnostic.h"
#include "core/base/field.h"
#include "core/base/geometry.h"
#include "core/nc/text/dialect.h"
#include "core/simulation/setup/setup_fields.h"

namespace proveout::cli {

/// The given options by field key; the parser has checked their texts.
using GivenFields = std::map<std::string, std::string>;

/// A visitor of describe() that adds an option for each field, with the help of the field, its range and its
/// default. The map must outlive the parsing.
struct OptionAdder {
    CLI::App& command;
    GivenFields& given;
    std::string group = "Options";
    std::map<std::string, std::string> defaultTexts = {}; ///< by key, if the text differs from the value

    void operator()(double value, const Field& field) const;
    void operator()(int value, const Field& field) const;
    /// A flag that toggles the value, or an option with the keys of the choices.
    void operator()(bool value, const Field& field) const;
    void operator()(const std::optional<int>& value, const Field& field) const;
    void operator()(const std::optional<Vec3>& value, const Field& field) const;
    void operator()(const std::optional<DialectId>& value, const Field& field) const;
    void operator()(const std::set<int>& value, const Field& field) const;
    void operator()(GridPlace<const double, const bool> grid, const Field& field) const;
    template<class Enumeration>
    requires std::is_enum_v<Enumeration>
    void operator()(Enumeration value, const Field& field) const {
        addChoices(static_cast<std::size_t>(value), field);
    }

private:
    [[nodiscard]] CLI::Option* add(const Field& field, const std::string& help) const;
    void addFlag(const std::string& option, const char* text, const std::string& help,
                 const Field& field) const;
    void addChoices(std::size_t value, const Field& field) const;
    [[nodiscard]] std::string help(const Field& field, const std::string& defaultText) const;
};

/// A visitor of describe() that reads the given options. The first error is kept in `result`.
struct OptionReader {
    const GivenFields& given;
    Result<void>& result;

    void operator()(double& value, const Field& field) const;
    void operator()(int& value, const Field& field) const;
    void operator()(bool& value, const Field& field) const;
    void operator()(std::optional<int>& value, const Field& field) const;
    void operator()(std::optional<Vec3>& value, const Field& field) const;
    void operator()(std::optional<DialectId>& value, const Field& field) const;
    /// Adds to the existing numbers.
    void operator()(std::set<int>& value, const Field& field) const;
    void operator()(GridPlace<double, bool> grid, const Field& field) const;
    template<class Enumeration>
    requires std::is_enum_v<Enumeration>
    void operator()(Enumeration& value, const Field& field) const {
        if (const std::string* text = find(field))
            value = static_cast<Enumeration>(indexOf(*text, field));
    }

private:
    [[nodiscard]] const std::string* find(const Field& field) const;
    [[nodiscard]] static std::size_t indexOf(const std::string& text, const Field& field);
    void fail(const Field& field, Diagnostics diagnostics) const;
};

[[nodiscard]] std::set<std::string> dialectKeys();

/// "rapidXY (mm/min), …": the keys of a described struct that is set by one option.
template<class Params>
[[nodiscard]] std::string keysWithUnits() {
    std::string keys;
    const Params params;
    describe(params, [&keys](const auto&, const Field& field) {
        keys += (keys.empty() ? "" : ", ") + std::string(field.key) + " (" + field.unit + ")";
    });
    return keys;
}

} // namespace proveout::cli
