// SPDX-License-Identifier: GPL-3.0-or-later
// One description per parameter, read by panel, settings, job file, command line and validation alike.
#pragma once

#include <concepts>
#include <span>
#include <type_traits>

namespace proveout {

/// One value of an enumerated parameter.
struct Choice {
    const char* key;   ///< in files and on the command line
    const char* label; ///< for the user interface; marked with PROVEOUT_TEXT
};

/// `Params` is `Struct`, const or not.
template<class Params, class Struct>
concept ParametersOf = std::same_as<std::remove_const_t<Params>, Struct>;

/// The description of one field of a parameter struct. A struct of parameters offers
///     template<ParametersOf<Struct> Params, class Visitor> void describe(Params& params, Visitor&& visit);
/// which calls `visit(field, description)` once per field; a visitor is a generic lambda or a set of
/// overloads.
struct Field {
    const char* key;    ///< in files; on the command line too, where `option` is empty
    const char* label;  ///< for the user interface; marked with PROVEOUT_TEXT
    const char* unit;   ///< "mm", "cells", …; may be empty
    const char* help;   ///< one sentence: the effect of the parameter; marked with PROVEOUT_TEXT
    double minimum = 0; ///< numbers only
    double maximum = 0; ///< numbers only
    double step = 0;    ///< numbers only
    std::span<const Choice> choices = {}; ///< enumerations only, in the order of their values
    const char* option = "";              ///< on the command line, without its dashes
    const char* automatic = ""; ///< what "auto" means, where that is a value; marked with PROVEOUT_TEXT
    int decimals = 3;           ///< shown by a form; numbers only
};

/// On the command line, without its dashes.
[[nodiscard]] constexpr const char* optionOf(const Field& field) {
    return *field.option == '\0' ? field.key : field.option;
}

/// Also false where `number` is not a number.
[[nodiscard]] constexpr bool isInRange(const Field& field, double number) {
    return number >= field.minimum && number <= field.maximum;
}

/// Whether the number is limited; the rows of other fields leave the range empty.
[[nodiscard]] constexpr bool hasRange(const Field& field) {
    return field.minimum < field.maximum;
}

} // namespace proveout
