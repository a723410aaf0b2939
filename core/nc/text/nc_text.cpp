// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of the text are runs of whole lines of shared buffers. An edit replaces the lines it touches by
// a new, small buffer; small neighbours are merged into it, so that typing does not leave a piece per key.
#include "core/nc/text/nc_text.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

namespace proveout {

namespace {

constexpr std::size_t kSmallPiece = 4096;
constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";

/// Bytes and where their lines begin; a line end after the last byte does not begin a line here.
struct Buffer {
    std::string bytes;
    std::vector<std::uint32_t> lineStarts;
    bool loneCr = false; ///< a line ends with CR alone

    Buffer(std::string text, std::size_t skipped) : bytes(std::move(text)) {
        assert(bytes.size() < std::numeric_limits<std::uint32_t>::max());
        std::size_t lineFeed = bytes.find('\n', skipped);
        for (std::size_t at = skipped; at < bytes.size();) {
            lineStarts.push_back(static_cast<std::uint32_t>(at));
            // Searched only once per line feed: a text with only CR must not cost a search per line.
            if (lineFeed != std::string::npos && lineFeed < at)
                lineFeed = bytes.find('\n', at);
            at = endOfLine(at, std::min(lineFeed, bytes.size()));
        }
    }

    /// The index after the line end (LF, CR LF or CR) of the line that begins at `at`; the next line feed, or
    /// the end of the text, is at `reach`.
    [[nodiscard]] std::size_t endOfLine(std::size_t at, std::size_t reach) {
        const std::size_t past = std::min(reach + 1, bytes.size());
        const auto* const cr = static_cast<const char*>(std::memchr(bytes.data() + at, '\r', reach - at));
        if (cr == nullptr)
            return past;
        const auto afterCr = static_cast<std::size_t>(cr - bytes.data()) + 1;
        if (afterCr == reach && past > reach)
            return past;
        loneCr = true;
        return afterCr;
    }
};

struct Piece {
    std::shared_ptr<const Buffer> buffer;
    std::size_t firstLine; ///< in the buffer
    std::size_t lines;
    std::size_t textLine;   ///< lines of the text before this piece
    std::size_t textOffset; ///< bytes of the text before this piece

    [[nodiscard]] std::size_t start(std::size_t line) const {
        const std::size_t index = firstLine + line;
        return index < buffer->lineStarts.size() ? buffer->lineStarts[index] : buffer->bytes.size();
    }
    [[nodiscard]] std::size_t size() const { return start(lines) - start(0); }
    /// The bytes of one line, including its line end.
    [[nodiscard]] std::string_view bytesOf(std::size_t line) const {
        return std::string_view(buffer->bytes).substr(start(line), start(line + 1) - start(line));
    }
    [[nodiscard]] std::string_view bytes() const {
        return std::string_view(buffer->bytes).substr(start(0), size());
    }
    /// The line of this piece that holds its byte `offset`.
    [[nodiscard]] std::size_t lineAt(std::size_t offset) const {
        const auto begin = buffer->lineStarts.begin() + static_cast<std::ptrdiff_t>(firstLine);
        const auto end = begin + static_cast<std::ptrdiff_t>(lines);
        return static_cast<std::size_t>(std::upper_bound(begin, end, start(0) + offset) - begin) - 1;
    }
};

bool endsLine(std::string_view text) {
    return text.ends_with('\n') || text.ends_with('\r');
}

} // namespace

struct NcText::State {
    std::vector<Piece> pieces;
    std::size_t size = 0;
    std::size_t lines = 0; ///< without the empty one after a last line end
    bool byteOrderMark = false;

    void add(std::shared_ptr<const Buffer> buffer, std::size_t firstLine, std::size_t count) {
        if (count == 0)
            return;
        pieces.push_back({std::move(buffer), firstLine, count, lines, size});
        size += pieces.back().size();
        lines += count;
    }
    /// Adds the lines [first, last) of a piece of another state.
    void add(const Piece& piece, std::size_t first, std::size_t last) {
        add(piece.buffer, piece.firstLine + first, last - first);
    }
    void add(std::string text, std::size_t skipped = 0) {
        auto buffer = std::make_shared<const Buffer>(std::move(text), skipped);
        const std::size_t count = buffer->lineStarts.size();
        add(std::move(buffer), 0, count);
    }

    [[nodiscard]] bool endsWithLineEnd() const { return pieces.empty() || endsLine(pieces.back().bytes()); }

    [[nodiscard]] std::size_t pieceOfLine(std::size_t line) const {
        const auto next =
            std::upper_bound(pieces.begin(), pieces.end(), line,
                             [](std::size_t l, const Piece& piece) { return l < piece.textLine; });
        return static_cast<std::size_t>(next - pieces.begin()) - 1;
    }

    /// The line that contains the byte at `offset`; `lines` for the end of the text after a line end.
    [[nodiscard]] std::size_t lineAt(std::size_t offset) const {
        if (offset >= size)
            return endsWithLineEnd() ? lines : lines - 1;
        const auto next =
            std::upper_bound(pieces.begin(), pieces.end(), offset,
                             [](std::size_t o, const Piece& piece) { return o < piece.textOffset; });
        const Piece& piece = *std::prev(next);
        return piece.textLine + piece.lineAt(offset - piece.textOffset);
    }

    [[nodiscard]] std::size_t offsetOfLine(std::size_t line) const {
        if (line >= lines)
            return size;
        const Piece& piece = pieces[pieceOfLine(line)];
        return piece.textOffset + piece.start(line - piece.textLine) - piece.start(0);
    }

    /// Appends the bytes [from, to) of the text to `out`.
    void copy(std::size_t from, std::size_t to, std::string& out) const {
        for (const Piece& piece : pieces) {
            const std::size_t begin = std::max(from, piece.textOffset);
            const std::size_t end = std::min(to, piece.textOffset + piece.size());
            if (begin < end)
                out += piece.bytes().substr(begin - piece.textOffset, end - begin);
        }
    }

    /// Adds the lines [first, last) of `other` without copying their bytes.
    void share(const State& other, std::size_t first, std::size_t last) {
        for (const Piece& piece : other.pieces) {
            const std::size_t begin = std::max(first, piece.textLine);
            const std::size_t end = std::min(last, piece.textLine + piece.lines);
            if (begin < end)
                add(piece, begin - piece.textLine, end - piece.textLine);
        }
    }

    /// Extends the lines [first, last) by small pieces beside them.
    void widen(std::size_t& first, std::size_t& last) const {
        if (first > 0 && first <= lines) {
            const Piece& before = pieces[pieceOfLine(first - 1)];
            if (offsetOfLine(first) - before.textOffset < kSmallPiece)
                first = before.textLine;
        }
        if (last < lines) {
            const Piece& after = pieces[pieceOfLine(last)];
            if (after.textOffset + after.size() - offsetOfLine(last) < kSmallPiece)
                last = after.textLine + after.lines;
        }
    }
};

NcText::NcText() : NcText(std::string()) {}

NcText::NcText(std::string text) {
    const std::size_t mark = text.starts_with(kUtf8Mark) ? kUtf8Mark.size() : 0;
    auto state = std::make_shared<State>();
    state->byteOrderMark = mark > 0;
    state->add(std::move(text), mark);
    m_state = std::move(state);
}

std::size_t NcText::size() const {
    return m_state->size;
}

std::size_t NcText::lineCount() const {
    return m_state->lines + (m_state->endsWithLineEnd() ? 1 : 0);
}

std::string_view NcText::line(std::size_t index) const {
    assert(index < lineCount());
    if (index >= m_state->lines)
        return {};
    const Piece& piece = m_state->pieces[m_state->pieceOfLine(index)];
    const std::size_t begin = piece.start(index - piece.textLine);
    const std::size_t end = piece.start(index - piece.textLine + 1);
    std::string_view line = std::string_view(piece.buffer->bytes).substr(begin, end - begin);
    if (line.ends_with('\n'))
        line.remove_suffix(1);
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    return line;
}

bool NcText::hadByteOrderMark() const {
    return m_state->byteOrderMark;
}

std::size_t NcText::firstLoneCr() const {
    for (const Piece& piece : m_state->pieces) {
        // The buffer may contain lines that are no longer part of the text, so its flag is only a first
        // guess.
        for (std::size_t i = 0; piece.buffer->loneCr && i < piece.lines; ++i) {
            if (piece.buffer->bytes[piece.start(i + 1) - 1] == '\r')
                return piece.textLine + i;
        }
    }
    return lineCount();
}

std::string NcText::toString() const {
    std::string text;
    text.reserve(m_state->size);
    m_state->copy(0, m_state->size, text);
    return text;
}

std::vector<std::string_view> NcText::runs() const {
    std::vector<std::string_view> runs;
    for (const Piece& piece : m_state->pieces)
        runs.push_back(piece.bytes());
    return runs;
}

std::size_t NcText::sameLines(const NcText& other) const {
    const State& mine = *m_state;
    const State& theirs = *other.m_state;
    if (mine.byteOrderMark != theirs.byteOrderMark)
        return 0;
    auto a = mine.pieces.begin();
    auto b = theirs.pieces.begin();
    std::size_t line = 0;
    while (a != mine.pieces.end() && b != theirs.pieces.end()) {
        const std::size_t inA = line - a->textLine;
        const std::size_t inB = line - b->textLine;
        std::size_t same = std::min(a->lines - inA, b->lines - inB);
        if (a->buffer != b->buffer || a->firstLine + inA != b->firstLine + inB) {
            const std::size_t most = std::exchange(same, 0);
            while (same < most && a->bytesOf(inA + same) == b->bytesOf(inB + same))
                ++same;
            if (same < most)
                return line + same;
        }
        line += same;
        a += line == a->textLine + a->lines ? 1 : 0;
        b += line == b->textLine + b->lines ? 1 : 0;
    }
    return line;
}

NcText NcText::replaced(std::size_t offset, std::size_t removed, std::string_view inserted) const {
    const State& old = *m_state;
    assert(offset <= old.size && removed <= old.size - offset);
    // Whole lines are replaced. The line before is included, because its CR may become the first half of a CR
    // LF.
    std::size_t first = old.lineAt(offset);
    first -= first > 0 ? 1 : 0;
    std::size_t last = std::min(old.lineAt(offset + removed) + 1, old.lines);
    old.widen(first, last);

    std::string text;
    old.copy(old.offsetOfLine(first), offset, text);
    text += inserted;
    old.copy(offset + removed, old.offsetOfLine(last), text);

    auto state = std::make_shared<State>();
    state->byteOrderMark = old.byteOrderMark;
    state->share(old, 0, first);
    state->add(std::move(text));
    state->share(old, last, old.lines);
    NcText result;
    result.m_state = std::move(state);
    return result;
}

} // namespace proveout
