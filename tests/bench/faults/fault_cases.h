// SPDX-License-Identifier: GPL-3.0-or-later
// The cases of the fault table (shared/RELIABILITY.md) as files to open, for the command line and the window.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace proveout {

/// What another program does to a file while it is open.
enum class WhileOpen : std::uint8_t { nothing, changed, shrunk, removed };

struct FaultCase {
    int number = 0;             ///< number in the table; 0: a file that is not in the table
    std::string name;           ///< the name in the table
    std::filesystem::path file; ///< a program, or a job (*.proveout)
    double seconds = 1;         ///< time limit of the command line
    bool headless = true;
    bool window = true;
    std::vector<std::string> setup = {}; ///< options that replace the usual stock, grid and tool
    WhileOpen whileOpen = WhileOpen::nothing;
};

/// A case that does not consist of one file to open.
struct FaultElsewhere {
    int number = 0;
    const char* what;
    const char* test; ///< empty: no test covers it
};

/// A temporary folder, removed with its files.
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

/// All cases in the sequence of the table, written into `folder`: copies from `shared`/corpus, and generated
/// files. `big`: includes those of hundreds of megabytes.
[[nodiscard]] std::vector<FaultCase> writeFaultCases(const std::filesystem::path& folder,
                                                     const std::filesystem::path& shared, bool big);

[[nodiscard]] const std::vector<FaultElsewhere>& faultsElsewhere();

/// Number and name for a table, without line ends and terminal control characters.
[[nodiscard]] std::string shownName(const FaultCase& fault);

/// A message without the path of the cases' folder, with a shortened sentence.
[[nodiscard]] std::string shortened(const std::string& message, const std::filesystem::path& folder);

/// From messages in the format of oneLine(): the first error or fault, otherwise the first warning, otherwise
/// the first note.
[[nodiscard]] std::string leadingMessage(const std::vector<std::string>& messages);

/// Prints the rows of faultsElsewhere().
void printFaultsElsewhere();

} // namespace proveout
