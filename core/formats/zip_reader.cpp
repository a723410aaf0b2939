// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/zip_reader.h"

#include <archive.h>
#include <archive_entry.h>
#include <new>
#include <system_error>

#include "core/base/base_findings.h"
#include "core/formats/mesh_findings.h"

namespace proveout {

namespace {

constexpr std::size_t kBlock = 65536;

} // namespace

ZipReader::ZipReader() : m_archive(archive_read_new()) {
    if (m_archive == nullptr)
        throw std::bad_alloc();
    // Reads the directory of the archive, which gives the length of each entry.
    archive_read_support_format_zip_seekable(m_archive);
}

ZipReader::~ZipReader() {
    archive_read_free(m_archive);
}

Result<void> ZipReader::open(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (error)
        return failure(base_finding::kFileUnreadable, {error.message()}, file.string());
    if (status.type() != std::filesystem::file_type::regular)
        return failure(base_finding::kFileNotRegular, {}, file.string());
    if (archive_read_open_filename(m_archive, file.c_str(), kBlock) != ARCHIVE_OK)
        return failure(mesh_finding::kFileNotZip, {}, file.string());
    return {};
}

std::string ZipReader::nextEntry() {
    m_broken = false;
    archive_entry* entry = nullptr;
    if (archive_read_next_header(m_archive, &entry) != ARCHIVE_OK)
        return {};
    const char* name = archive_entry_pathname(entry);
    return name == nullptr ? std::string() : name;
}

std::size_t ZipReader::read(void* bytes, std::size_t count) {
    std::size_t done = 0;
    while (done < count && !m_broken) {
        const la_ssize_t got = archive_read_data(m_archive, static_cast<char*>(bytes) + done, count - done);
        m_broken = got < 0;
        if (got <= 0)
            break;
        done += static_cast<std::size_t>(got);
    }
    return done;
}

bool ZipReader::intact() {
    char beyond = 0;
    return read(&beyond, 1) == 0 && !m_broken;
}

} // namespace proveout
