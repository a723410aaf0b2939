// SPDX-License-Identifier: GPL-3.0-or-later
// One description per parameter, read by panel, settings, job file, command line and validation alike.
#pragma once

#include <span>
#include <type_traits>

namespace proveout {

/// One value of an enumerated parameter.
struct Choice {
    const char* key;   ///< in files and on the command line
    const char* label; ///< for people; marked with PROVEOUT_TEXT
};

/// The description of one field of a parameter struct. A struct of parameters offers
///     template<class Params, class Visitor> void describe(Params& params, Visitor&& visit);
/// which calls `visit(field, description)` once per field; a visitor is a generic lambda or a set of
/// overloads.
struct Field {
    const char* key;    ///< in files and on the command line
    const char* label;  ///< for people; marked with PROVEOUT_TEXT
    const char* unit;   ///< "mm", "cells", …; may be empty
    const char* help;   ///< one sentence: the effect of the parameter; marked with PROVEOUT_TEXT
    double minimum = 0; ///< numbers only
    double maximum = 0; ///< numbers only
    double step = 0;    ///< numbers only
    std::span<const Choice> choices = {}; ///< enumerations only, in the order of their values
};

} // namespace proveout
