// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/disk_copy.h"

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include <QCryptographicHash>

#include "core/base/atomic_file.h"
#include "core/base/base_findings.h"

namespace proveout {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kChunk = std::size_t{1} << 16;

/// Whether the next bytes of the stream are equal to `bytes`.
bool holds(std::ifstream& stream, std::string_view bytes, std::vector<char>& chunk) {
    while (!bytes.empty()) {
        const std::size_t count = std::min(bytes.size(), chunk.size());
        stream.read(chunk.data(), static_cast<std::streamsize>(count));
        if (!stream ||
            !std::equal(chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(count), bytes.begin()))
            return false;
        bytes.remove_prefix(count);
    }
    return true;
}

} // namespace

DiskCopy::DiskCopy(NcText text, bool byteOrderMark)
    : m_text(std::move(text)), m_byteOrderMark(byteOrderMark), m_known(true) {}

Result<DiskState> DiskCopy::compare(const fs::path& file) const {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found)
        return DiskState::missing;
    if (status.type() == fs::file_type::directory)
        return failure(base_finding::kFileNotRegularFolder, {}, file.string());
    if (status.type() != fs::file_type::regular)
        return failure(base_finding::kFileNotRegular, {}, file.string());
    if (!m_known)
        return m_state && *m_state == stateOf(file) ? DiskState::same : DiskState::changed;
    const std::uintmax_t mark = m_byteOrderMark ? kByteOrderMark.size() : 0;
    if (fs::file_size(file, error) != mark + m_text.size() && !error)
        return DiskState::changed;
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return failure(base_finding::kFileUnreadable, {std::generic_category().message(errno)},
                       file.string());
    std::vector<char> chunk(kChunk);
    if (m_byteOrderMark && !holds(stream, kByteOrderMark, chunk))
        return DiskState::changed;
    for (const std::string_view run : m_text.runs())
        if (!holds(stream, run, chunk))
            return DiskState::changed;
    return stream.peek() == std::ifstream::traits_type::eof() ? DiskState::same : DiskState::changed;
}

std::string DiskCopy::digest() const {
    if (!m_known)
        return {};
    QCryptographicHash hash(QCryptographicHash::Sha256);
    const auto add = [&hash](std::string_view bytes) {
        hash.addData(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())));
    };
    if (m_byteOrderMark)
        add(kByteOrderMark);
    for (const std::string_view run : m_text.runs())
        add(run);
    return hash.result().toHex().toStdString();
}

Result<DiskCopy> DiskCopy::read(const fs::path& file, std::uint64_t limit) {
    Result<std::string> bytes = readFile(file, limit);
    if (!bytes)
        return tl::unexpected(std::move(bytes.error()));
    const bool byteOrderMark = bytes->starts_with(kByteOrderMark);
    return DiskCopy(NcText(std::move(*bytes)), byteOrderMark);
}

} // namespace proveout
