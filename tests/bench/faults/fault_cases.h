// SPDX-License-Identifier: GPL-3.0-or-later
// The cases of the fault table (shared/RELIABILITY.md) as files to open, for the command line and the window.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace proveout {

/// What somebody else does to a file while it is open.
enum class WhileOpen : std::uint8_t { nothing, changed, shrunk, removed };

struct FaultCase {
    int number = 0;             ///< in the table; 0: a file that the table does not name
    std::string name;           ///< as the table has it
    std::filesystem::path file; ///< a program, or a job (*.proveout)
    double seconds = 1;         ///< that the command line may take
    bool headless = true;
    bool window = true;
    std::vector<std::string> setup = {}; ///< options in the place of the usual stock, grid and tool
    WhileOpen whileOpen = WhileOpen::nothing;
};

/// A case that is not one file to open.
struct FaultElsewhere {
    int number = 0;
    const char* what;
    const char* test; ///< empty: nothing covers it
};

/// A folder that goes with its files.
class FaultFolder {
public:
    FaultFolder();
    ~FaultFolder();
    FaultFolder(const FaultFolder&) = delete;
    FaultFolder& operator=(const FaultFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

/// All cases in the order of the table, written into `folder`: copies from `shared`/corpus, and what is made
/// here. `big`: with those of hundreds of megabytes.
[[nodiscard]] std::vector<FaultCase> writeFaultCases(const std::filesystem::path& folder,
                                                     const std::filesystem::path& shared, bool big);

[[nodiscard]] const std::vector<FaultElsewhere>& faultsElsewhere();

/// For a table: its number and its name, without line ends and what terminals obey.
[[nodiscard]] std::string shownName(const FaultCase& fault);

/// A message without the folder of the cases, its sentence shortened.
[[nodiscard]] std::string shortened(const std::string& message, const std::filesystem::path& folder);

/// Of messages in the form of oneLine(): the first error or fault, else the first warning, else the first
/// note.
[[nodiscard]] std::string leadingMessage(const std::vector<std::string>& messages);

/// Prints the rows of faultsElsewhere().
void printFaultsElsewhere();

} // namespace proveout
