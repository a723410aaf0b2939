// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/new_file_beside.h"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <unistd.h>

#include "core/base/base_findings.h"

namespace proveout {

Result<std::filesystem::path> newFileBeside(const std::filesystem::path& file) {
    constexpr int kMost = 10'000;
    for (int number = 2; number < kMost; ++number) {
        std::filesystem::path beside = file;
        beside.replace_filename(file.stem().string() + '-' + std::to_string(number) +
                                file.extension().string());
        const int descriptor = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0) {
            ::close(descriptor);
            return beside;
        }
        if (errno != EEXIST)
            break;
    }
    return failure(base_finding::kFileUnwritable, {std::generic_category().message(errno)}, file.string());
}

} // namespace proveout
