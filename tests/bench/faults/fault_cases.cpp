// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/faults/fault_cases.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "core/base/memory.h"
#include "tests/bench/faults/written_faults.h"

namespace proveout {

namespace {

namespace fs = std::filesystem;

struct TableRow {
    int number;
    std::vector<const char*> files;
};

/// The files of the corpus with their numbers in the table.
const std::vector<TableRow>& tableRows() {
    static const std::vector<TableRow> rows{
        {1, {"empty", "percent-only"}},
        {2, {"nul-1k", "binary-64k"}},
        {3, {"bom-utf16le"}},
        {4, {"eol-mixed"}},
        {5, {"ctrl-z", "dc-codes"}},
        {6, {"utf8-comment", "bad-utf8"}},
        {7, {"unicode-minus", "nonascii-word"}},
        {8, {"digits-1M"}},
        {9, {"num-1e308", "num-nan"}},
        {10, {"num-double-sign", "num-two-points"}},
        {11, {"unary-10k"}},
        {13, {"param-limits", "named-long"}},
        {14, {"n-overflow"}},
        {15, {"unclosed-comment", "nested-comment"}},
        {16, {"modal-conflict", "dup-word", "five-m"}},
        {17, {"rotary"}},
        {18, {"arc-no-centre", "arc-zero"}},
        {20, {"arc-centre-far"}},
        {22, {"cycle-L-huge", "m98-L-huge"}},
        {24, {"o-while-forever", "goto-loop"}},
        {25, {"m98-mutual"}},
        {26, {"o-fork-bomb"}},
        {27, {"o-traversal", "o-special-file"}},
        {29, {"o-unmatched"}},
        {30, {"arc-in-comp"}},
        {31, {"feed-none"}},
        {32, {"tool-unknown"}},
        {33, {"tiny-moves"}},
        {34, {"huge-coord"}},
        {40, {"count-too-small"}},
        {41, {"binary-solid-header", "binary-solid-facet"}},
        {42, {"bin-nan", "ascii-nan", "bin-denormal"}},
        {43, {"zero-area", "wrong-normals"}},
        {44, {"one-flipped"}},
        {45, {"hole", "bowtie", "t-junction", "nearly-closed"}},
        {46, {"far-origin"}},
        {47, {"zip-named-stl", "obj-named-stl"}},
    };
    return rows;
}

int numberOf(const std::string& name) {
    for (const TableRow& row : tableRows())
        if (std::ranges::find(row.files, name) != row.files.end())
            return row.number;
    return 0;
}

std::vector<fs::path> filesOf(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().find(".oracle.") == std::string::npos)
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

void copyInto(const fs::path& folder, const fs::path& file) {
    fs::copy_file(file, folder / file.filename());
    fs::permissions(folder / file.filename(), fs::perms::owner_write, fs::perm_options::add);
}

void copyCorpus(FaultWriter& writer, const fs::path& shared) {
    for (const fs::path& file : filesOf(shared / "corpus" / "faults-nc")) {
        copyInto(writer.folder(), file);
        const std::string name = file.stem().string();
        writer.add({.number = numberOf(name), .name = name, .file = writer.folder() / file.filename()});
    }
    for (const fs::path& file : filesOf(shared / "corpus" / "faults-stl")) {
        copyInto(writer.folder(), file);
        const std::string name = file.stem().string();
        writer.putStock(numberOf(name), name, "stl", file.filename().string());
    }
}

} // namespace

FaultFolder::FaultFolder() {
    std::string name = (fs::temp_directory_path() / "proveout-faults-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw std::runtime_error("no folder for the cases");
    m_path = name;
}

FaultFolder::~FaultFolder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

FaultCase& FaultWriter::add(FaultCase fault) {
    return m_cases.emplace_back(std::move(fault));
}

FaultCase& FaultWriter::put(int number, const std::string& name, const std::string& ending,
                            const std::string& bytes) {
    write(name + ending, bytes);
    return add({.number = number, .name = name, .file = m_folder / (name + ending)});
}

FaultCase& FaultWriter::putStock(int number, const std::string& name, const std::string& shape,
                                 const std::string& body, double grid) {
    const std::string job = fmt::format(R"({{"proveout": 2, "program": "cube.nc", "start": [0, 0, 50],
"grid": {}, "tools": {{"1": "flat:d=4,l=20"}}, "stock": {{"shape": "{}", "file": "{}"}}}}
)",
                                        grid, shape, body);
    return put(number, name, ".proveout", job);
}

void FaultWriter::write(const std::string& file, const std::string& bytes) const {
    std::ofstream out(m_folder / file, std::ios::binary);
    out << bytes;
    if (!out.flush())
        throw std::runtime_error("cannot write " + file);
}

void FaultWriter::lengthen(const std::string& file, std::uintmax_t bytes) const {
    fs::resize_file(m_folder / file, bytes);
}

std::vector<FaultCase> writeFaultCases(const fs::path& folder, const fs::path& shared, bool big) {
    std::vector<FaultCase> cases;
    FaultWriter writer(folder, cases);
    writer.write("cube.nc", "G21 G90\nT1 M6\nG0 X2 Y-5 Z30\nG1 Z8 F100\nY15\nG0 Z30\nM30\n");
    copyCorpus(writer, shared);
    writeTextFaults(writer);
    writeProgramFaults(writer);
    writeFileFaults(writer);
    writeMeshFaults(writer);
    writeJobFaults(writer);
    if (big)
        writeBigFaults(writer);
    returnFreedMemory(); // the measured peak of a child starts at the memory of its parent
    // Files that are not in the table come last.
    const auto place = [](const FaultCase& fault) { return fault.number == 0 ? 1000 : fault.number; };
    std::ranges::stable_sort(cases, {}, place);
    return cases;
}

} // namespace proveout
