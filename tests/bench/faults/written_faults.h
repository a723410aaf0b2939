// SPDX-License-Identifier: GPL-3.0-or-later
// Cases that are not in the corpus.
#pragma once

#include <string>

#include "tests/bench/faults/fault_cases.h"

namespace proveout {

/// Writes cases into a folder and collects them.
class FaultWriter {
public:
    FaultWriter(std::filesystem::path folder, std::vector<FaultCase>& cases)
        : m_folder(std::move(folder)), m_cases(cases) {}

    /// Writes a file with these bytes; `name` without its extension.
    FaultCase& put(int number, const std::string& name, const std::string& ending, const std::string& bytes);
    /// Writes a job that uses this body (e.g. an STL) as its stock. `body` must be in the folder already.
    FaultCase& putStock(int number, const std::string& name, const std::string& shape,
                        const std::string& body, double grid = 0.5);
    FaultCase& add(FaultCase fault);

    [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }
    void write(const std::string& file, const std::string& bytes) const;
    /// Extends a file to this length; the extension uses no disk space.
    void lengthen(const std::string& file, std::uintmax_t bytes) const;

private:
    std::filesystem::path m_folder;
    std::vector<FaultCase>& m_cases;
};

void writeTextFaults(FaultWriter& writer);    ///< 2 to 17
void writeProgramFaults(FaultWriter& writer); ///< 18 to 36
void writeFileFaults(FaultWriter& writer);    ///< 36 to 38
void writeMeshFaults(FaultWriter& writer);    ///< 39 to 48
void writeJobFaults(FaultWriter& writer);     ///< 49 to 63
void writeBigFaults(FaultWriter& writer);     ///< 35, 48 and 63: hundreds of megabytes

} // namespace proveout
