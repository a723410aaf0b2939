// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace proveout {

struct Include {
    int line = 0;
    bool angled = false; ///< <…> if true, "…" if false
    std::string target;
};

/// A text file of the repository.
struct SourceFile {
    std::string path; ///< from the root, e.g. "core/nc/lexer.cpp"
    std::string text;
    std::vector<Include> includes; ///< for C++ files

    [[nodiscard]] bool isCpp() const; ///< .h or .cpp
    [[nodiscard]] bool in(const std::string& folder) const { return path.starts_with(folder + "/"); }
    /// The first `depth` parts of the path, e.g. "core/nc"; empty if the path is shorter.
    [[nodiscard]] std::string room(int depth = 2) const;
};

/// All files below core, ui, app, resources, tests and translations, sorted by path.
[[nodiscard]] const std::vector<SourceFile>& sourceTree();

} // namespace proveout
