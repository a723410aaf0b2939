// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/job_json.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "core/base/figures_argument.h"
#include "core/base/nearest_name.h"
#include "core/formats/job_findings.h"

namespace proveout {

namespace {

using nlohmann::json;

/// Used in place of a missing object.
const json& emptyObject() {
    static const json kEmpty = json::object();
    return kEmpty;
}

} // namespace

bool JsonFields::has(const char* key) {
    return find(key) != nullptr;
}

const json* JsonFields::find(const char* key) {
    m_asked.insert(key);
    const auto found = m_object->find(key);
    return found == m_object->end() ? nullptr : &*found;
}

void JsonFields::fail(std::string_view key, const FindingRow& row, std::vector<Argument> arguments) {
    fail(key, {}, row, std::move(arguments));
}

void JsonFields::fail(std::string_view key, std::string_view element, const FindingRow& row,
                      std::vector<Argument> arguments) {
    arguments.insert(arguments.begin(), fmt::format("{}{}{}", m_path, key, element));
    const auto place = m_document->places.find({m_here.object, std::string(key)});
    Diagnostic error = diagnosticOf(row, std::move(arguments));
    error.where = place == m_document->places.end() ? m_here.where : place->second.where;
    m_complaints->errors.add(std::move(error));
}

void JsonFields::warnAboutUnknown() {
    const std::vector<std::string_view> known(m_asked.begin(), m_asked.end());
    const auto& places = m_document->places;
    const auto isThere = [this](const auto& field) {
        return field != m_document->places.end() && field->first.first == m_here.object;
    };
    for (auto field = places.lower_bound({m_here.object, {}}); isThere(field); ++field) {
        const std::string& name = field->first.second;
        if (m_asked.contains(name))
            continue;
        if (m_complaints->warnings.full()) {
            m_complaints->warnings.omit(Severity::warning, false, 1);
            continue;
        }
        const auto meant = nearestName(name, known);
        Diagnostic warning = meant.empty() ? diagnosticOf(job_finding::kJobFieldUnknown, {m_path + name})
                                           : diagnosticOf(job_finding::kJobFieldUnknownMeant,
                                                          {m_path + name, m_path + std::string(meant)});
        warning.where = field->second.where;
        m_complaints->warnings.add(std::move(warning));
    }
}

void JsonFields::require(std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
        if (!has(key))
            fail(key, job_finding::kJobFieldMissing, {});
    }
}

bool JsonFields::readNumber(std::string_view key, std::string_view element, const json& value, double& number,
                            const JsonRange& range) {
    const double read = value.is_number() ? value.get<double>() : std::nan("");
    const bool within = range.aboveMinimum ? read > range.minimum : read >= range.minimum;
    if (within && read <= range.maximum) {
        number = read;
        return true;
    }
    fail(key, element, range.aboveMinimum ? job_finding::kJobFieldAbove : job_finding::kJobFieldRange,
         {figures("{}", range.minimum), figures("{}", range.maximum)});
    return false;
}

bool JsonFields::readString(std::string_view key, const json& value, std::string& text) {
    // A NUL would end the text early in system calls.
    if (value.is_string() && value.get_ref<const std::string&>().find('\0') == std::string::npos) {
        text = value.get<std::string>();
        return true;
    }
    fail(key, job_finding::kJobFieldText, {});
    return false;
}

void JsonFields::read(const char* key, double& value, const JsonRange& range) {
    if (const json* field = find(key))
        static_cast<void>(readNumber(key, {}, *field, value, range));
}

void JsonFields::read(const char* key, int& value, const JsonRange& range) {
    const json* field = find(key);
    double number = 0;
    if (field == nullptr || !readNumber(key, {}, *field, number, range))
        return;
    if (number != std::floor(number))
        fail(key, job_finding::kJobFieldWhole, {});
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
        fail(key, job_finding::kJobFieldFlag, {});
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
        fail(key, job_finding::kJobFieldPoint, {});
        return;
    }
    for (int axis = 0; axis < 3; ++axis)
        static_cast<void>(readNumber(key, fmt::format("[{}]", axis), (*field)[static_cast<std::size_t>(axis)],
                                     point[axis], range));
}

void JsonFields::read(const char* key, std::set<int>& numbers, int most) {
    const json* field = find(key);
    if (field == nullptr)
        return;
    std::set<int> read;
    const auto isNumber = [most](const json& one) {
        return one.is_number_integer() && one.get<double>() >= 0 && one.get<double>() <= most;
    };
    if (!field->is_array() || !std::all_of(field->begin(), field->end(), isNumber)) {
        fail(key, job_finding::kJobFieldList, {std::to_string(most)});
        return;
    }
    for (const json& one : *field)
        read.insert(one.get<int>());
    numbers = std::move(read);
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
    fail(key, job_finding::kJobFieldChoice, {allowed});
}

std::vector<std::string> JsonFields::keys() const {
    std::vector<std::string> keys;
    for (const auto& item : m_object->items())
        keys.push_back(item.key());
    return keys;
}

JsonFields JsonFields::object(const char* key) {
    const json* field = find(key);
    if (field != nullptr && !field->is_object())
        fail(key, job_finding::kJobFieldObject, {});
    const bool usable = field != nullptr && field->is_object();
    JsonFields fields = *this;
    fields.m_object = usable ? field : &emptyObject();
    fields.m_path = m_path + key + ".";
    fields.m_here = field == nullptr ? JsonPlace{} : m_document->places.at({m_here.object, key});
    fields.m_asked.clear();
    return fields;
}

} // namespace proveout
