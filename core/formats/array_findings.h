// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about NumPy arrays that are read as z-maps.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::array_finding {

inline constexpr FindingRow kNpyType{
    Severity::error,
    false,
    "npy-type",
    PROVEOUT_TEXT("Core", "Unsupported NPY type"),
    PROVEOUT_TEXT("Core", "The NPY file holds values of type \"{}\"; little-endian float32 (\"<f4\") or "
                          "float64 (\"<f8\") is needed."),
    ""};
inline constexpr FindingRow kNpyOrder{
    Severity::error,
    false,
    "npy-order",
    PROVEOUT_TEXT("Core", "Unsupported NPY order"),
    PROVEOUT_TEXT("Core", "The NPY file is in Fortran order; C order is needed."),
    ""};
inline constexpr FindingRow kNpyShape{
    Severity::error,
    false,
    "npy-shape",
    PROVEOUT_TEXT("Core", "Unsupported NPY shape"),
    PROVEOUT_TEXT("Core", "The NPY file has the shape {}; two dimensions (rows, columns) are needed."),
    ""};
inline constexpr FindingRow kNpyShapeLarge{
    Severity::error,
    false,
    "npy-shape",
    PROVEOUT_TEXT("Core", "Unsupported NPY shape"),
    PROVEOUT_TEXT("Core", "The NPY file has the shape {}; that is too large."),
    ""};
inline constexpr FindingRow kNpyCutOff{
    Severity::error,
    false,
    "npy-cut-off",
    PROVEOUT_TEXT("Core", "NPY file cut off"),
    PROVEOUT_TEXT("Core",
                  "The header of the NPY file specifies {} values ({}), but only {} are in the file."),
    ""};
inline constexpr FindingRow kNpyCutOffHeader{
    Severity::error,
    false,
    "npy-cut-off",
    PROVEOUT_TEXT("Core", "NPY file cut off"),
    PROVEOUT_TEXT("Core", "The NPY file ends at byte {}, within its header of {} bytes."),
    ""};
inline constexpr FindingRow kNpyValue{
    Severity::error,
    false,
    "npy-value",
    PROVEOUT_TEXT("Core", "Height not finite"),
    PROVEOUT_TEXT(
        "Core",
        "The value in row {}, column {} (counted from 0) is {}; heights must be finite and fit float32."),
    ""};
inline constexpr FindingRow kNpyHeader{
    Severity::error,
    false,
    "npy-header",
    PROVEOUT_TEXT("Core", "NPY header not readable"),
    PROVEOUT_TEXT("Core", "The header of the NPY file cannot be read at byte {}."),
    ""};
inline constexpr FindingRow kNotNpy{Severity::error,
                                    false,
                                    "not-npy",
                                    PROVEOUT_TEXT("Core", "Not an NPY file"),
                                    PROVEOUT_TEXT("Core", "This is not an NPY file."),
                                    ""};
inline constexpr FindingRow kNpyVersion{
    Severity::error,
    false,
    "npy-version",
    PROVEOUT_TEXT("Core", "Unsupported NPY version"),
    PROVEOUT_TEXT("Core", "The NPY file has format version {}; versions 1 to 3 are known."),
    ""};

inline constexpr std::array kArrayRows{&kNpyType,   &kNpyOrder,        &kNpyShape, &kNpyShapeLarge,
                                       &kNpyCutOff, &kNpyCutOffHeader, &kNpyValue, &kNpyHeader,
                                       &kNotNpy,    &kNpyVersion};

} // namespace proveout::array_finding
