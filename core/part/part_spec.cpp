// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/part_spec.h"

#include "core/base/described_values.h"
#include "core/part/part_findings.h"

namespace proveout {

namespace {

constexpr DescribedFindings kFindings{part_finding::kValue, part_finding::kKey};

/// Whether a text is a value of a part, whose file is missing.
bool isValue(std::string_view text) {
    bool found = false;
    const PartSpec part;
    describe(part, [&](double, const Field& field) {
        const std::string_view key(field.key);
        found = found || (text.starts_with(key) && text.substr(key.size()).starts_with('='));
    });
    return found;
}

} // namespace

Result<PartSpec> parsePart(std::string_view text, const PartSpec& before) {
    const auto parts = valuesBeforeFile(text);
    Result<PartSpec> part = before;
    if (parts)
        part = parseDescribed(parts->values, before, kFindings);
    if (!part)
        return part;
    part->file = parts ? parts->file : text;
    if (part->file.empty() || (!parts && isValue(text)))
        return failure(part_finding::kNoFile);
    return part;
}

Result<PartTolerance> parseTolerance(std::string_view text, const PartTolerance& before) {
    const std::size_t comma = text.find(',');
    const std::string_view below = text.substr(0, comma);
    const std::string_view above = comma == std::string_view::npos ? below : text.substr(comma + 1);
    PartTolerance tolerance = before;
    if (auto set = setDescribed(tolerance, part_field::kBelow.key, below, kFindings); !set)
        return tl::unexpected(std::move(set.error()));
    if (auto set = setDescribed(tolerance, part_field::kAbove.key, above, kFindings); !set)
        return tl::unexpected(std::move(set.error()));
    return tolerance;
}

} // namespace proveout
