// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace proveout {

namespace {

std::vector<Include> includesOf(const std::string& text) {
    std::vector<Include> includes;
    std::istringstream stream(text);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        constexpr std::string_view kDirective = "#include ";
        if (!line.starts_with(kDirective) || line.size() <= kDirective.size())
            continue;
        const char open = line[kDirective.size()];
        const std::size_t begin = kDirective.size() + 1;
        const std::size_t end = line.find(open == '<' ? '>' : '"', begin);
        includes.push_back({number, open == '<', line.substr(begin, end - begin)});
    }
    return includes;
}

SourceFile load(const std::filesystem::path& root, const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    SourceFile file{
        path.lexically_relative(root).generic_string(), {std::istreambuf_iterator<char>(stream), {}}, {}};
    if (file.isCpp())
        file.includes = includesOf(file.text);
    return file;
}

std::vector<SourceFile> loadTree() {
    const std::filesystem::path root(PROVEOUT_SOURCE_DIR);
    std::vector<SourceFile> files;
    for (const char* folder : {"app", "core", "resources", "tests", "translations", "ui"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder))
            if (entry.is_regular_file())
                files.push_back(load(root, entry.path()));
    std::sort(files.begin(), files.end(),
              [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return files;
}

} // namespace

bool SourceFile::isCpp() const {
    return path.ends_with(".h") || path.ends_with(".cpp");
}

std::string SourceFile::room(int depth) const {
    std::size_t end = 0;
    for (int part = 0; part < depth; ++part) {
        end = path.find('/', part == 0 ? 0 : end + 1);
        if (end == std::string::npos)
            return {};
    }
    return path.substr(0, end);
}

const std::vector<SourceFile>& sourceTree() {
    static const std::vector<SourceFile> kTree = loadTree();
    return kTree;
}

} // namespace proveout
