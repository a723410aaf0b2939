// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/job_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "core/base/text.h"

namespace proveout {

namespace {

using nlohmann::json;

TextRange placeOf(std::string_view text, std::size_t offset) {
    const auto before = text.substr(0, std::min(offset, text.size()));
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const auto lineStart = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    return {static_cast<int>(lines) + 1, static_cast<int>(before.size() - lineStart) + 1, 0};
}

/// Walks through the text once before anything is built: it knows the depth, and the place of every error
/// (the exceptions of the parser proper do not tell the place of a number out of range).
class SyntaxCheck : public nlohmann::json_sax<json> {
public:
    explicit SyntaxCheck(int depth) : m_depthLeft(depth) {}

    [[nodiscard]] std::size_t errorOffset() const { return m_errorOffset; }
    [[nodiscard]] bool tooDeep() const { return m_tooDeep; }

    bool null() override { return true; }
    bool boolean(bool /*value*/) override { return true; }
    bool number_integer(number_integer_t /*value*/) override { return true; }
    bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
    bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
    bool string(string_t& /*value*/) override { return true; }
    bool binary(binary_t& /*value*/) override { return true; }
    bool key(string_t& /*value*/) override { return true; }
    bool start_object(std::size_t /*size*/) override { return enter(); }
    bool start_array(std::size_t /*size*/) override { return enter(); }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }
    bool parse_error(std::size_t offset, const std::string& /*token*/,
                     const nlohmann::detail::exception& /*error*/) override {
        m_errorOffset = offset > 0 ? offset - 1 : 0; // it counts the bytes read, the wrong one included
        return false;
    }

private:
    bool enter() {
        m_tooDeep = --m_depthLeft < 0;
        return !m_tooDeep;
    }
    bool leave() {
        ++m_depthLeft;
        return true;
    }

    int m_depthLeft;
    bool m_tooDeep = false;
    std::size_t m_errorOffset = 0;
};

/// What stands for an object that is not there.
const json& emptyObject() {
    static const json kEmpty = json::object();
    return kEmpty;
}

} // namespace

Result<json> parseJson(std::string_view text, int depth) {
    SyntaxCheck check(depth);
    if (json::sax_parse(text, &check))
        return json::parse(text);
    if (check.tooDeep())
        return failure("json-depth", PROVEOUT_TEXT("Core", "The brackets are nested deeper than {} levels."),
                       {std::to_string(depth)});
    auto failed = failure("json-syntax", PROVEOUT_TEXT("Core", "This is not valid JSON."));
    failed.value().front().where = placeOf(text, check.errorOffset());
    return failed;
}

JsonFields::JsonFields(const json& object, std::string path, Diagnostics& errors)
    : m_object(&object), m_path(std::move(path)), m_errors(&errors) {}

bool JsonFields::has(const char* key) const {
    return find(key) != nullptr;
}

const json* JsonFields::find(const char* key) const {
    const auto found = m_object->find(key);
    return found == m_object->end() ? nullptr : &*found;
}

void JsonFields::fail(std::string_view key, const char* text, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), m_path + std::string(key));
    m_errors->push_back(failure("job-field", text, std::move(arguments)).value().front());
}

void JsonFields::require(std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
        if (!has(key))
            fail(key, PROVEOUT_TEXT("Core", "The field \"{}\" is missing."), {});
    }
}

bool JsonFields::readNumber(std::string_view key, const json& value, double& number, const JsonRange& range) {
    const double read = value.is_number() ? value.get<double>() : std::nan("");
    const bool within = range.aboveMinimum ? read > range.minimum : read >= range.minimum;
    if (within && read <= range.maximum) {
        number = read;
        return true;
    }
    fail(key,
         range.aboveMinimum
             ? PROVEOUT_TEXT("Core", "The field \"{}\" must be a number above {} and at most {}.")
             : PROVEOUT_TEXT("Core", "The field \"{}\" must be a number from {} to {}."),
         {fmt::format("{}", range.minimum), fmt::format("{}", range.maximum)});
    return false;
}

bool JsonFields::readString(std::string_view key, const json& value, std::string& text) {
    // A NUL would end the text early for the system.
    if (value.is_string() && value.get_ref<const std::string&>().find('\0') == std::string::npos) {
        text = value.get<std::string>();
        return true;
    }
    fail(key, PROVEOUT_TEXT("Core", "The field \"{}\" must be a text."), {});
    return false;
}

void JsonFields::read(const char* key, double& value, const JsonRange& range) {
    if (const json* field = find(key))
        static_cast<void>(readNumber(key, *field, value, range));
}

void JsonFields::read(const char* key, int& value, const JsonRange& range) {
    const json* field = find(key);
    double number = 0;
    if (field == nullptr || !readNumber(key, *field, number, range))
        return;
    if (number != std::floor(number))
        fail(key, PROVEOUT_TEXT("Core", "The field \"{}\" must be a whole number."), {});
    else
        value = static_cast<int>(number);
}

void JsonFields::read(const char* key, bool& value) {
    const json* field = find(key);
    if (field == nullptr)
        return;
    if (field->is_boolean())
        value = field->get<bool>();
    else
        fail(key, PROVEOUT_TEXT("Core", "The field \"{}\" must be true or false."), {});
}

void JsonFields::read(const char* key, std::string& value) {
    if (const json* field = find(key))
        static_cast<void>(readString(key, *field, value));
}

void JsonFields::read(const char* key, Vec3& point, const JsonRange& range) {
    const json* field = find(key);
    if (field == nullptr)
        return;
    if (!field->is_array() || field->size() != 3) {
        fail(key, PROVEOUT_TEXT("Core", "The field \"{}\" must be three numbers [x, y, z]."), {});
        return;
    }
    for (int axis = 0; axis < 3; ++axis)
        static_cast<void>(readNumber(fmt::format("{}[{}]", key, axis),
                                     (*field)[static_cast<std::size_t>(axis)], point[axis], range));
}

void JsonFields::read(const char* key, std::size_t& index, std::span<const Choice> choices) {
    const json* field = find(key);
    if (field == nullptr)
        return;
    const std::string named = field->is_string() ? field->get<std::string>() : std::string();
    const auto found = std::find_if(choices.begin(), choices.end(),
                                    [&named](const Choice& choice) { return named == choice.key; });
    if (found != choices.end()) {
        index = static_cast<std::size_t>(found - choices.begin());
        return;
    }
    std::string allowed;
    for (const Choice& choice : choices)
        allowed += fmt::format("{}\"{}\"", allowed.empty() ? "" : ", ", choice.key);
    fail(key, PROVEOUT_TEXT("Core", "The field \"{}\" must be one of {}."), {allowed});
}

JsonFields JsonFields::object(const char* key) {
    const json* field = find(key);
    if (field != nullptr && !field->is_object())
        fail(key, PROVEOUT_TEXT("Core", "The field \"{}\" must be an object { }."), {});
    const bool usable = field != nullptr && field->is_object();
    return {usable ? *field : emptyObject(), m_path + key + ".", *m_errors};
}

} // namespace proveout
