// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/described_json.h"

#include <vector>

#include "core/nc/codes/dialects.h"

namespace proveout {

namespace {

constexpr JsonRange kSpacing{0, 1e6, true}; ///< mm; makeGrid() checks what is possible
constexpr const char* kDetected = "auto";   ///< the dialect is detected from the program

JsonRange rangeOf(const Field& field) {
    return {field.minimum, field.maximum};
}

} // namespace

void FieldReader::operator()(double& value, const Field& field) const {
    fields.read(field.key, value, rangeOf(field));
}

void FieldReader::operator()(int& value, const Field& field) const {
    fields.read(field.key, value, rangeOf(field));
}

void FieldReader::operator()(bool& value, const Field& field) const {
    if (field.choices.empty()) {
        fields.read(field.key, value);
        return;
    }
    std::size_t index = value ? 1 : 0;
    fields.read(field.key, index, field.choices);
    value = index == 1;
}

void FieldReader::operator()(std::optional<int>& value, const Field& field) const {
    if (fields.has(field.key))
        fields.read(field.key, value.emplace(0), rangeOf(field));
}

void FieldReader::operator()(std::optional<Vec3>& value, const Field& field) const {
    if (fields.has(field.key))
        fields.read(field.key, value.emplace(0), rangeOf(field));
}

void FieldReader::operator()(std::optional<DialectId>& value, const Field& field) const {
    std::vector<Choice> choices{{kDetected, ""}};
    for (const Dialect& row : dialects())
        choices.push_back({row.key, row.name});
    std::size_t index = 0;
    fields.read(field.key, index, choices);
    if (index > 0)
        value = static_cast<DialectId>(index - 1);
}

void FieldReader::operator()(std::set<int>& value, const Field& field) const {
    fields.read(field.key, value, static_cast<int>(field.maximum));
}

void FieldReader::operator()(GridPlace<double, bool> grid, const Field& field) const {
    grid.automatic = !fields.has(field.key);
    fields.read(field.key, grid.spacing, kSpacing);
}

void FieldWriter::operator()(bool value, const Field& field) const {
    if (field.choices.empty())
        out[field.key] = value;
    else if (value)
        out[field.key] = field.choices[1].key;
}

void FieldWriter::operator()(const std::optional<int>& value, const Field& field) const {
    if (value)
        out[field.key] = *value;
}

void FieldWriter::operator()(const std::optional<Vec3>& value, const Field& field) const {
    if (value)
        out[field.key] = {value->x, value->y, value->z};
}

void FieldWriter::operator()(const std::optional<DialectId>& value, const Field& field) const {
    if (value)
        out[field.key] = dialect(*value).key;
}

void FieldWriter::operator()(const std::set<int>& value, const Field& field) const {
    if (!value.empty())
        out[field.key] = value;
}

void FieldWriter::operator()(GridPlace<const double, const bool> grid, const Field& field) const {
    if (!grid.automatic)
        out[field.key] = grid.spacing;
}

} // namespace proveout
