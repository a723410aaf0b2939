// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of the disk and of file names.
#include <filesystem>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include "tests/bench/faults/written_faults.h"

namespace proveout {

namespace {

const std::string kProgram = "G21 G90\nT1 M6\nG0 X2 Y-5 Z9\nG1 Z-2 F100\nY15\nG0 Z9\nG777\nM30\n";

void addNoFile(FaultWriter& writer, const std::string& name, const std::filesystem::path& file) {
    writer.add({.number = 37, .name = name, .file = file});
}

} // namespace

void writeFileFaults(FaultWriter& writer) {
    for (const auto& [name, what] :
         {std::pair{"file-changed", WhileOpen::changed}, std::pair{"file-shrunk", WhileOpen::shrunk},
          std::pair{"file-removed", WhileOpen::removed}}) {
        FaultCase& fault = writer.put(36, name, ".ngc", kProgram);
        fault.whileOpen = what;
        fault.headless = false;
    }
    const std::filesystem::path& folder = writer.folder();
    if (::mkfifo((folder / "fifo.ngc").c_str(), 0600) != 0)
        throw std::runtime_error("no FIFO");
    std::filesystem::create_directory(folder / "folder.ngc");
    addNoFile(writer, "fifo", folder / "fifo.ngc");
    addNoFile(writer, "dev-zero", "/dev/zero");
    addNoFile(writer, "folder", folder / "folder.ngc");
    addNoFile(writer, "gone", folder / "gone.ngc");
    addNoFile(writer, "folder-gone", folder / "gone" / "p.ngc");
    if (::geteuid() != 0) { // root may read everything
        writer.put(37, "no-permission", ".ngc", kProgram);
        std::filesystem::permissions(folder / "no-permission.ngc", std::filesystem::perms::none);
    }
    for (const std::string& name :
         {std::string("line\nbreak"), std::string(251, 'n'), std::string("caf\xe9\xff"),
          std::string("\xe2\x80\xaegnp"), std::string("-dash"), std::string("quo'te \"blank")})
        writer.put(38, name, ".ngc", kProgram);
}

} // namespace proveout
