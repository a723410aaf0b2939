// SPDX-License-Identifier: GPL-3.0-or-later
// Reports of a check for other programs, made from the objects of `check --json`.
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

namespace proveout::cli {

/// SARIF 2.1.0 (OASIS): one result per finding, for code reviews and editors.
class SarifReport {
public:
    void add(const nlohmann::ordered_json& checked);
    [[nodiscard]] std::string text() const;

private:
    nlohmann::ordered_json m_rules = nlohmann::ordered_json::array();
    nlohmann::ordered_json m_results = nlohmann::ordered_json::array();
    std::set<std::string> m_known; ///< ids of m_rules
};

/// JUnit XML: one test case per program; faults are failures, and a program that is not verified is an error.
class JunitReport {
public:
    void add(const nlohmann::ordered_json& checked);
    [[nodiscard]] std::string text() const;

private:
    std::string m_cases;
    std::size_t m_tests = 0;
    std::size_t m_failures = 0;
    std::size_t m_errors = 0;
    double m_seconds = 0;
};

} // namespace proveout::cli
