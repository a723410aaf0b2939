// SPDX-License-Identifier: GPL-3.0-or-later
// Runs LinuxCNC's stand-alone interpreter, the program `rs274` of the Debian package linuxcnc-uspace.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/nc/state/tool_offsets.h"
#include "tests/core/nc/oracle_records.h"

namespace proveout::test {

/// A working directory for running it; it writes into its home.
class Rs274 {
public:
    explicit Rs274(const std::map<int, ToolOffset>& tools);
    Rs274(const Rs274&) = delete;
    Rs274& operator=(const Rs274&) = delete;
    ~Rs274();

    [[nodiscard]] static bool isInstalled();

    /// The result for a program. An endless program is stopped after some seconds or calls; its class is then
    /// "timeout".
    [[nodiscard]] OracleAnswer run(const std::string& program) const;

private:
    void readErrors(OracleAnswer& answer, const std::string& program) const;

    std::filesystem::path m_home;
};

} // namespace proveout::test
