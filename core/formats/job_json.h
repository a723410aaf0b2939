// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of a job file: converts JSON into checked values. Internal to this library.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bounded_diagnostics.h"
#include "core/base/diagnostic.h"
#include "core/base/field.h"
#include "core/base/geometry.h"
#include "core/formats/json_document.h"

namespace proveout {

/// The numbers allowed for a field.
struct JsonRange {
    double minimum = 0;
    double maximum = 0;
    bool aboveMinimum = false; ///< whether the minimum itself is excluded
};

/// The problems found while the fields were read.
struct JsonComplaints {
    BoundedDiagnostics errors;
    BoundedDiagnostics warnings;
};

/// An object of the file, read field by field. A missing field leaves the value unchanged; a wrong one adds
/// an error with its path and place. Holds references: the document and the complaints must outlive it.
class JsonFields {
public:
    JsonFields(const JsonDocument& document, JsonComplaints& complaints)
        : m_document(&document), m_complaints(&complaints), m_object(&document.root), m_here{{}, 0} {}

    [[nodiscard]] bool has(const char* key);
    /// Adds an error for each of `keys` that is missing.
    void require(std::initializer_list<const char*> keys);

    void read(const char* key, double& value, const JsonRange& range);
    void read(const char* key, int& value, const JsonRange& range);
    void read(const char* key, bool& value);
    void read(const char* key, std::string& value);
    void read(const char* key, Vec3& point, const JsonRange& range);
    /// An array of whole numbers from 0 to `most`.
    void read(const char* key, std::set<int>& numbers, int most);
    /// The index of the choice that the field names.
    void read(const char* key, std::size_t& index, std::span<const Choice> choices);
    /// The names of all fields.
    [[nodiscard]] std::vector<std::string> keys() const;
    /// The object `key`; an empty one if it is missing or not an object.
    [[nodiscard]] JsonFields object(const char* key);
    /// Calls `visit(key, text)` for every field, each of which must be a string.
    template<class Visitor>
    void eachString(Visitor&& visit) {
        for (const auto& item : m_object->items()) {
            std::string text;
            if (readString(item.key(), item.value(), text))
                visit(item.key(), text);
        }
    }

    /// Adds an error about `key`: "the field …: …".
    void fail(std::string_view key, const FindingRow& row, std::vector<Argument> arguments);

    /// Call it after all known fields have been read: it warns about every field that was not read, and names
    /// the known one that was probably intended.
    void warnAboutUnknown();

private:
    [[nodiscard]] const nlohmann::json* find(const char* key);
    [[nodiscard]] bool readString(std::string_view key, const nlohmann::json& value, std::string& text);
    /// `element`: the element of an array, "[1]"; empty if the field is the number itself.
    [[nodiscard]] bool readNumber(std::string_view key, std::string_view element, const nlohmann::json& value,
                                  double& number, const JsonRange& range);
    void fail(std::string_view key, std::string_view element, const FindingRow& row,
              std::vector<Argument> arguments);

    const JsonDocument* m_document;
    JsonComplaints* m_complaints;
    const nlohmann::json* m_object;
    std::string m_path; ///< ends with a dot unless it is empty
    JsonPlace m_here;   ///< of the whole object; without a place for the outermost one
    std::set<std::string, std::less<>> m_asked;
};

} // namespace proveout
