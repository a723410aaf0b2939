// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "core/base/diagnostic.h"
#include "core/part/design_part.h"
#include "core/part/part_spec.h"

namespace proveout {

/// A design part as its file holds it, placed.
struct PartContents {
    std::shared_ptr<const DesignPart> part = {}; ///< null: the file cannot be used; the findings say why
    Diagnostics findings = {};                   ///< what was repaired, and what may be wrong with it

    friend bool operator==(const PartContents&, const PartContents&) = default;
};

/// Reads and places the part of a job. What is safe is repaired: facets that are there twice, a mesh that is
/// inside out. An open mesh is used where it is closed. Refused: a file that cannot be read, an unknown
/// format, facets that face to opposite sides, more than `memoryBytes`. Takes as long as reading the file;
/// any thread.
[[nodiscard]] PartContents readPart(const PartSpec& spec, std::uint64_t memoryBytes);

} // namespace proveout
