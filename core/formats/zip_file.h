// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/atomic_file.h"
#include "core/base/diagnostic.h"

struct archive;

namespace proveout {

/// A ZIP archive, written front to back into an AtomicFile: only the memory of the compression is needed, and
/// the archive appears whole or not at all. No times are stored, so equal entries give equal bytes. Owned by
/// one thread. Errors: kept and reported by `commit()`; writing after an error is harmless.
class ZipFile {
public:
    /// `zip64`: whether an entry may reach 4 GB. Not all readers support that form, so it is used only where
    /// it is needed.
    ZipFile(std::filesystem::path target, bool zip64);
    ZipFile(const ZipFile&) = delete;
    ZipFile& operator=(const ZipFile&) = delete;
    ~ZipFile();

    /// Everything written from now on belongs to the entry with this name (ASCII).
    void beginEntry(const char* name);
    void write(std::string_view bytes);
    /// Bytes of the archive written by now.
    [[nodiscard]] std::uint64_t bytesWritten() const { return m_out.bytesWritten(); }
    [[nodiscard]] bool failed() const { return m_out.failed() || !m_problem.empty(); }

    /// Once.
    [[nodiscard]] Result<void> commit();

private:
    void check(int status);

    std::filesystem::path m_target;
    AtomicFile m_out;
    archive* m_archive;
    std::string m_problem; ///< the error of the compression
};

} // namespace proveout
