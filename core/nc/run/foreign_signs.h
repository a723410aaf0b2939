// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of texts that no supported dialect reads: kinds of programs and files, and the signs that
// identify them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace proveout {

enum class ForeignKind : std::uint8_t {
    heidenhain,
    heidenhainIso,
    siemens,
    okuma,
    winCnc,
    shopBot,
    lathe,
    printer,
    apt,
    gerber,
    excellon,
    hpgl,
    camotics,
    job,
    json,
    svg,
    html,
    xml,
    stl,
    obj,
    ply,
    step,
    dxf,
    postScript,
    pdf,
    richText,
    count
};

struct ForeignKindRow {
    const char* name; ///< marked with PROVEOUT_TEXT
    bool program;     ///< of another control; otherwise not an NC program
};

/// The form of a line that a pattern is matched with: all are in upper case, without blanks at both ends and
/// with one between words.
enum class LineForm : std::uint8_t {
    first,    ///< the first line that is not empty, with comments
    line,     ///< any line, with comments
    block,    ///< without comments and block number
    squeezed, ///< the same, without any blanks
};

/// Signs of one kind decide if their total weight is at least this.
inline constexpr int kForeignDecides = 100;

struct ForeignSign {
    ForeignKind kind;
    int weight;
    LineForm form;
    std::string_view pattern; ///< glob.h
};

inline constexpr std::size_t kForeignKinds = static_cast<std::size_t>(ForeignKind::count);

[[nodiscard]] const ForeignKindRow& rowOf(ForeignKind kind);
[[nodiscard]] std::span<const ForeignSign> foreignSigns();

} // namespace proveout
