// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/zip_file.h"

#include <archive.h>
#include <archive_entry.h>
#include <new>
#include <utility>

#include "core/base/base_findings.h"

namespace proveout {

namespace {

/// A mesh as XML shrinks to a fifth or a sixth at the lowest level. The default level saves another quarter
/// and is four times as slow.
constexpr const char* kCompression = "zip:compression-level=1";

/// Never reports an error to the archive: the file keeps it, and counts how many bytes were needed.
la_ssize_t writeInto(archive* /*from*/, void* file, const void* bytes, std::size_t count) {
    static_cast<AtomicFile*>(file)->write(bytes, count);
    return static_cast<la_ssize_t>(count);
}

} // namespace

ZipFile::ZipFile(std::filesystem::path target, bool zip64)
    : m_target(target), m_out(std::move(target)), m_archive(archive_write_new()) {
    if (m_archive == nullptr)
        throw std::bad_alloc();
    check(archive_write_set_format_zip(m_archive));
    check(archive_write_set_options(m_archive, kCompression));
    check(archive_write_set_options(m_archive, zip64 ? "zip:zip64" : "zip:!zip64"));
    check(archive_write_set_bytes_in_last_block(m_archive, 1)); // no padding with zeros at the end
    check(archive_write_open(m_archive, &m_out, nullptr, writeInto, nullptr));
}

ZipFile::~ZipFile() {
    // If commit() was not called, this completes the archive into a file that is discarded: if asked to abort
    // (archive_write_fail), libarchive 3.6 would never free the memory of the compression.
    archive_write_free(m_archive);
}

void ZipFile::check(int status) {
    if (status != ARCHIVE_OK && m_problem.empty()) {
        const char* reason = archive_error_string(m_archive);
        m_problem = reason == nullptr ? "compression failed" : reason;
    }
}

void ZipFile::beginEntry(const char* name) {
    const std::unique_ptr<archive_entry, decltype(&archive_entry_free)> entry(archive_entry_new(),
                                                                              archive_entry_free);
    if (entry == nullptr)
        throw std::bad_alloc();
    constexpr int kReadableByAll = 0644;
    archive_entry_set_pathname(entry.get(), name);
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), kReadableByAll);
    check(archive_write_header(m_archive, entry.get()));
}

void ZipFile::write(std::string_view bytes) {
    if (!m_problem.empty())
        return;
    const la_ssize_t taken = archive_write_data(m_archive, bytes.data(), bytes.size());
    if (taken != static_cast<la_ssize_t>(bytes.size()))
        check(ARCHIVE_FATAL);
}

Result<void> ZipFile::commit() {
    if (m_problem.empty() && !m_out.failed())
        check(archive_write_close(m_archive));
    if (!m_problem.empty())
        return failure(base_finding::kFileUnwritable, {m_problem}, m_target.string());
    return m_out.commit();
}

} // namespace proveout
