// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_results.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include "app/cli/digest.h"
#include "core/verification/findings/command_line_findings.h"

namespace proveout::cli {

namespace {

using nlohmann::ordered_json;

bool isUnchanged(const ordered_json& checked) {
    const auto inputs = checked.find("inputs");
    if (inputs == checked.end() || !inputs->is_array() || inputs->empty())
        return false;
    for (const ordered_json& input : *inputs)
        if (sha256(input.value("file", std::string())) != input.value("sha256", std::string()))
            return false;
    return true;
}

} // namespace

std::string jsonLine(const ordered_json& object) {
    return object.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

Result<void> CheckResults::open(const std::filesystem::path& file, const std::string& settings) {
    bool endsWithLine = true;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        endsWithLine = !in.eof();
        ordered_json checked = ordered_json::parse(line, nullptr, false);
        if (!checked.is_object() || checked.value("settings", std::string()) != settings)
            continue;
        const std::string input = checked.value("input", std::string());
        m_known[input] = std::move(checked);
    }
    in.close();
    m_out.open(file, std::ios::app);
    if (!m_out)
        return failure(command_line_finding::kResultsUnwritable, {std::strerror(errno)}, file.string());
    if (!endsWithLine)
        m_out << '\n';
    return {};
}

const ordered_json* CheckResults::find(const std::filesystem::path& input) const {
    const auto known = m_known.find(input.string());
    return known != m_known.end() && isUnchanged(known->second) ? &known->second : nullptr;
}

void CheckResults::add(const ordered_json& checked) {
    if (m_out.is_open())
        m_out << jsonLine(checked) << std::endl;
}

} // namespace proveout::cli
