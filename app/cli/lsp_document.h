// SPDX-License-Identifier: GPL-3.0-or-later
// A text that an editor has open, and the positions in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "core/nc/text/nc_text.h"

namespace proveout::cli {

/// What the characters of a position count.
enum class PositionEncoding : std::uint8_t { utf16, utf8 };

/// Converts between a byte of a line and a position of the protocol. A position within a character is that of
/// its beginning, one after the end of the line is its end; a byte that is not UTF-8 counts as one character.
[[nodiscard]] std::size_t byteOf(std::string_view line, std::size_t position, PositionEncoding encoding);
[[nodiscard]] std::size_t positionOf(std::string_view line, std::size_t byte, PositionEncoding encoding);

/// The range [begin, end) of bytes of a line, 0-based, for the protocol.
[[nodiscard]] nlohmann::json rangeInLine(const NcText& text, std::size_t line, std::size_t begin,
                                         std::size_t end, PositionEncoding encoding);

/// The file that a URI names; empty if it names none.
[[nodiscard]] std::filesystem::path fileOfUri(std::string_view uri);
[[nodiscard]] std::string uriOfFile(const std::filesystem::path& file);

/// A document as the editor shows it: a byte order mark is part of its first line. Value type; copies are
/// cheap.
class LspDocument {
public:
    static constexpr std::size_t kLargest = 512'000'000; ///< bytes

    LspDocument() = default;
    LspDocument(std::string text, PositionEncoding encoding);

    /// Applies one entry of `contentChanges`. Throws InvalidParameter; the document is then unchanged.
    void change(const nlohmann::json& change);

    [[nodiscard]] const NcText& text() const { return m_text; }
    /// The text as a program: without a byte order mark.
    [[nodiscard]] NcText program() const;
    /// The number of bytes by which the first line is longer than that of program().
    [[nodiscard]] std::size_t markBytes() const;

private:
    [[nodiscard]] std::size_t offsetOf(const nlohmann::json& position) const;

    NcText m_text;
    PositionEncoding m_encoding = PositionEncoding::utf16;
};

} // namespace proveout::cli
