// SPDX-License-Identifier: GPL-3.0-or-later
// JSON as a job file has it: hostile text in, checked fields out. Inside the room only.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/base/diagnostic.h"
#include "core/base/field.h"
#include "core/base/geometry.h"

namespace proveout {

/// Parses JSON. Errors have line and column: syntax, numbers out of range, more than `depth` levels of
/// brackets.
[[nodiscard]] Result<nlohmann::json> parseJson(std::string_view text, int depth);

/// Numbers allowed for a field.
struct JsonRange {
    double minimum = 0;
    double maximum = 0;
    bool aboveMinimum = false; ///< the minimum itself is not allowed
};

/// An object of the file, read field by field. A field that is missing leaves the value as it is; a wrong one
/// adds an error that names its path. Holds references: the JSON and the list of errors must outlive it.
class JsonFields {
public:
    JsonFields(const nlohmann::json& object, std::string path, Diagnostics& errors);

    [[nodiscard]] bool has(const char* key) const;
    /// Adds an error for each of `keys` that is missing.
    void require(std::initializer_list<const char*> keys);

    void read(const char* key, double& value, const JsonRange& range);
    void read(const char* key, int& value, const JsonRange& range);
    void read(const char* key, bool& value);
    void read(const char* key, std::string& value);
    void read(const char* key, Vec3& point, const JsonRange& range);
    /// The index of the choice named.
    void read(const char* key, std::size_t& index, std::span<const Choice> choices);
    /// The object `key`; an empty one where it is missing or none.
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
    void fail(std::string_view key, const char* text, std::vector<std::string> arguments);

private:
    [[nodiscard]] const nlohmann::json* find(const char* key) const;
    [[nodiscard]] bool readString(std::string_view key, const nlohmann::json& value, std::string& text);
    [[nodiscard]] bool readNumber(std::string_view key, const nlohmann::json& value, double& number,
                                  const JsonRange& range);

    const nlohmann::json* m_object;
    std::string m_path; ///< with a dot at its end where it is not empty
    Diagnostics* m_errors;
};

} // namespace proveout
