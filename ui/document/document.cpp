// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/document.h"

#include <fstream>
#include <string_view>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/utf8.h"

namespace proveout {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool startsWithByteOrderMark(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string head(kByteOrderMark.size(), '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    return stream && head == kByteOrderMark;
}

} // namespace

LineEnd mostFrequentLineEnd(std::string_view text) {
    std::size_t lf = 0;
    std::size_t crLf = 0;
    std::size_t cr = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n') {
            ++lf;
        } else if (text[i] == '\r') {
            const bool pair = i + 1 < text.size() && text[i + 1] == '\n';
            ++(pair ? crLf : cr);
            i += pair ? 1 : 0;
        }
    }
    if (crLf > lf && crLf >= cr)
        return LineEnd::crLf;
    return cr > lf ? LineEnd::cr : LineEnd::lf;
}

namespace {

/// The first line, 1-based, that is too long for the editor; 0 if there is none.
std::size_t firstTooLong(const NcText& text) {
    for (std::size_t line = 0; line < text.lineCount(); ++line) {
        if (text.line(line).size() > kEditableLine)
            return line + 1;
    }
    return 0;
}

} // namespace

Result<Document> loadDocument(const std::filesystem::path& file, const WorkContext& context) {
    const FileState onDisk = stateOf(file); // taken first, so that a change during reading is reported
    Result<NcText> text = NcText::load(file, context);
    if (!text)
        return tl::unexpected(std::move(text.error()));
    Document document;
    document.path = file;
    document.onDisk = onDisk;
    document.text = std::move(*text);
    document.byteOrderMark = startsWithByteOrderMark(file);
    document.tooLongLine = firstTooLong(document.text);
    document.readOnly = document.text.size() > kEditableBytes || document.tooLongLine > 0;
    const std::vector<std::string_view> runs = document.text.runs();
    const std::string_view bytes =
        runs.empty() ? std::string_view() : runs.front(); // files are read in one piece
    document.utf8 = isUtf8(bytes);
    document.lineEnd = mostFrequentLineEnd(bytes);
    return document;
}

Result<Document> loadClosedDocument(const std::filesystem::path& file, const WorkContext& context) {
    Result<Document> document = loadDocument(file, context);
    if (!document) {
        // The place is in a text that is not open, and would be shown in the open one.
        for (Diagnostic& error : document.error())
            error.where = {};
    }
    return document;
}

Result<void> saveDocument(const Document& document, const std::filesystem::path& file) {
    AtomicFile out(file);
    if (document.byteOrderMark)
        out.write(kByteOrderMark);
    for (const std::string_view run : document.text.runs())
        out.write(run);
    return out.commit();
}

} // namespace proveout
