// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>

#include "core/base/atomic_file.h"
#include "core/base/text.h"
#include "core/nc/text/messages.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

namespace {

constexpr std::size_t kSample = 65536; ///< bytes that are examined

/// The name of a UTF-16 or UTF-32 encoding, identified by its byte order mark or by the positions of its zero
/// bytes.
const char* wideEncoding(std::string_view text) {
    if (text.starts_with(std::string_view("\xff\xfe\0\0", 4)) ||
        text.starts_with(std::string_view("\0\0\xfe\xff", 4)))
        return "UTF-32";
    if (text.starts_with("\xff\xfe"))
        return "UTF-16 LE";
    if (text.starts_with("\xfe\xff"))
        return "UTF-16 BE";
    std::size_t zeros[2] = {0, 0};
    for (std::size_t i = 0; i < text.size(); ++i)
        zeros[i % 2] += text[i] == '\0' ? 1 : 0;
    const std::size_t most = text.size() / 2 - text.size() / 20;
    if (text.size() >= 8 && zeros[1] >= most && zeros[0] == 0)
        return "UTF-16 LE";
    if (text.size() >= 8 && zeros[0] >= most && zeros[1] == 0)
        return "UTF-16 BE";
    return nullptr;
}

/// Codes that old tapes and serial lines leave in a program: tab, line ends, form feed, DC1 to DC4, the
/// end-of-file byte of DOS.
bool isTextByte(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x20 || (byte >= 0x09 && byte <= 0x0d) || (byte >= 0x11 && byte <= 0x14) || byte == 0x1a;
}

struct BinaryKind {
    std::string_view begin;
    const char* name;
};

constexpr BinaryKind kBinaryKinds[] = {
    {"\x89PNG", PROVEOUT_TEXT("Core", "a PNG picture")},
    {"\xff\xd8\xff", PROVEOUT_TEXT("Core", "a JPEG picture")},
    {"GIF8", PROVEOUT_TEXT("Core", "a GIF picture")},
    {"%PDF-", PROVEOUT_TEXT("Core", "a PDF document")},
    {"PK\x03\x04", PROVEOUT_TEXT("Core", "a ZIP archive, as 3MF, FreeCAD and office files are")},
    {"\x1f\x8b", PROVEOUT_TEXT("Core", "a gzip archive")},
    {"7z\xbc\xaf", PROVEOUT_TEXT("Core", "a 7z archive")},
    {"\xd0\xcf\x11\xe0", PROVEOUT_TEXT("Core", "an office or CAD document")},
    {"AutoCAD Binary DXF", PROVEOUT_TEXT("Core", "a DXF drawing")},
    {"\x7f"
     "ELF",
     PROVEOUT_TEXT("Core", "an executable file")},
};

/// The kind of a file that is not text; null if unknown.
const char* nameOfBinary(std::string_view bytes) {
    constexpr std::size_t kStlHead = 84;
    constexpr std::size_t kStlFacet = 50;
    const auto* row = std::ranges::find_if(
        kBinaryKinds, [&](const BinaryKind& kind) { return bytes.starts_with(kind.begin); });
    if (row != std::end(kBinaryKinds))
        return row->name;
    if (bytes.size() < kStlHead)
        return nullptr;
    std::uint32_t facets = 0;
    for (std::size_t i = 1; i <= sizeof facets; ++i)
        facets = facets << 8U | static_cast<unsigned char>(bytes[kStlHead - i]);
    return facets > 0 && bytes.size() == kStlHead + kStlFacet * facets ? PROVEOUT_TEXT("Core", "an STL mesh")
                                                                       : nullptr;
}

bool looksBinary(std::string_view text) {
    if (text.starts_with("\x89PNG") || text.find('\0') != std::string_view::npos)
        return true;
    const auto strange = std::count_if(text.begin(), text.end(), [](char c) { return !isTextByte(c); });
    return static_cast<std::size_t>(strange) * 50 > text.size();
}

} // namespace

Result<NcText> NcText::load(const std::filesystem::path& file, const WorkContext& context) {
    auto bytes = readFile(file, kLargestReadFile, context);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const std::string_view sample = std::string_view(*bytes).substr(0, kSample);
    if (const char* encoding = wideEncoding(sample)) {
        return failure(nc_message::kEncoding, {encoding}, file.string());
    }
    if (looksBinary(sample)) {
        if (const char* name = nameOfBinary(*bytes))
            return failure(nc_message::kBinaryKind, {name}, file.string());
        return failure(nc_message::kBinary, {}, file.string());
    }
    return NcText(*std::move(bytes));
}

} // namespace proveout
