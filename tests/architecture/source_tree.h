// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace proveout {

struct Include {
    int line = 0;
    bool angled = false; ///< <…>, else "…"
    std::string target;
};

/// A text file of the repository.
struct SourceFile {
    std::string path; ///< from the root, e.g. "core/nc/lexer.cpp"
    std::string text;
    std::vector<Include> includes; ///< of C++ files

    [[nodiscard]] bool isCpp() const; ///< .h or .cpp
    [[nodiscard]] bool in(const std::string& folder) const { return path.starts_with(folder + "/"); }
    /// The first `depth` parts of the path, e.g. "core/nc"; empty where the file does not lie that deep.
    [[nodiscard]] std::string room(int depth = 2) const;
};

/// All files below core, ui, app, resources, tests and translations, in order of their paths.
[[nodiscard]] const std::vector<SourceFile>& sourceTree();

} // namespace proveout
