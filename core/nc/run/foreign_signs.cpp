// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/foreign_signs.h"

#include <array>

#include "core/base/text.h"

namespace proveout {

namespace {

using Kind = ForeignKind;
using Look = LineForm;

constexpr int kDecides = kForeignDecides;
constexpr int kHalf = 50;  ///< two different signs of this weight decide
constexpr int kMore = 200; ///< decides against a kind that is more general

// In the order of Kind.
constexpr std::array<ForeignKindRow, kForeignKinds> kKinds{{
    {PROVEOUT_TEXT("Core", "a Heidenhain conversational program"), true},
    {PROVEOUT_TEXT("Core", "a Heidenhain DIN/ISO program"), true},
    {PROVEOUT_TEXT("Core", "a Siemens Sinumerik program"), true},
    {PROVEOUT_TEXT("Core", "an Okuma OSP program"), true},
    {PROVEOUT_TEXT("Core", "a WinCNC program"), true},
    {PROVEOUT_TEXT("Core", "a ShopBot program"), true},
    {PROVEOUT_TEXT("Core", "a lathe program"), true},
    {PROVEOUT_TEXT("Core", "a 3D printer program"), true},
    {PROVEOUT_TEXT("Core", "an APT or CL data file"), true},
    {PROVEOUT_TEXT("Core", "a Gerber file"), false},
    {PROVEOUT_TEXT("Core", "an Excellon drill file"), false},
    {PROVEOUT_TEXT("Core", "an HPGL plot file"), false},
    {PROVEOUT_TEXT("Core", "a CAMotics project"), false},
    {PROVEOUT_TEXT("Core", "a Proveout job"), false},
    {PROVEOUT_TEXT("Core", "a JSON file"), false},
    {PROVEOUT_TEXT("Core", "an SVG drawing"), false},
    {PROVEOUT_TEXT("Core", "an HTML page"), false},
    {PROVEOUT_TEXT("Core", "an XML file"), false},
    {PROVEOUT_TEXT("Core", "an STL mesh"), false},
    {PROVEOUT_TEXT("Core", "an OBJ mesh"), false},
    {PROVEOUT_TEXT("Core", "a PLY mesh"), false},
    {PROVEOUT_TEXT("Core", "a STEP model"), false},
    {PROVEOUT_TEXT("Core", "a DXF drawing"), false},
    {PROVEOUT_TEXT("Core", "a PostScript file"), false},
    {PROVEOUT_TEXT("Core", "a PDF document"), false},
    {PROVEOUT_TEXT("Core", "a rich text document"), false},
}};

constexpr ForeignSign kSigns[] = {
    // Source: HEIDENHAIN, TNC user's manuals, conversational programming.
    {Kind::heidenhain, kDecides, Look::block, "BEGIN PGM ~"},
    {Kind::heidenhain, kDecides, Look::block, "END PGM ~"},
    {Kind::heidenhain, kDecides, Look::block, "BLK FORM ~"},
    {Kind::heidenhain, kDecides, Look::block, "CYCL DEF ~"},
    {Kind::heidenhain, kDecides, Look::block, "TOOL CALL ~"},
    {Kind::heidenhain, kDecides, Look::block, "CALL LBL ~"},
    {Kind::heidenhain, kDecides, Look::block, "PLANE SPATIAL~"},
    {Kind::heidenhain, kHalf, Look::block, "TOOL DEF ~"},
    {Kind::heidenhain, kHalf, Look::block, "L ~ FMAX~"},
    {Kind::heidenhain, kHalf, Look::block, "L ~ R0~"},
    {Kind::heidenhain, kHalf, Look::block, "LBL #"},
    {Kind::heidenhain, kHalf, Look::block, "CC X~"},
    {Kind::heidenhain, kHalf, Look::block, "FN #:~"},
    {Kind::heidenhainIso, kDecides, Look::line, "%@ G70~\\*"},
    {Kind::heidenhainIso, kDecides, Look::line, "%@ G71~\\*"},
    // Source: SINUMERIK 840D sl, programming manuals.
    {Kind::siemens, kDecides, Look::line, "%_N_~"},
    {Kind::siemens, kDecides, Look::line, ";$PATH=~"},
    {Kind::siemens, kDecides, Look::first, "%MPF ~"},
    {Kind::siemens, kDecides, Look::first, "%MPF#~"},
    {Kind::siemens, kDecides, Look::first, "%SPF ~"},
    {Kind::siemens, kDecides, Look::first, "%SPF#~"},
    {Kind::siemens, kDecides, Look::block, "DEF REAL ~"},
    {Kind::siemens, kDecides, Look::block, "DEF INT ~"},
    {Kind::siemens, kDecides, Look::block, "DEF BOOL ~"},
    {Kind::siemens, kDecides, Look::block, "DEF STRING[~"},
    {Kind::siemens, kDecides, Look::block, "~CYCLE#(~"},
    {Kind::siemens, kDecides, Look::block, "~POCKET#(~"},
    {Kind::siemens, kDecides, Look::block, "MCALL~"},
    {Kind::siemens, kDecides, Look::block, "WORKPIECE(~"},
    {Kind::siemens, kDecides, Look::squeezed, "MSG(\"~"},
    {Kind::siemens, kDecides, Look::block, "~GOTOF @"},
    {Kind::siemens, kDecides, Look::block, "~GOTOB @"},
    {Kind::siemens, kDecides, Look::block, "ATRANS ~"},
    {Kind::siemens, kDecides, Look::block, "AROT ~"},
    {Kind::siemens, kDecides, Look::block, "STOPRE"},
    {Kind::siemens, kDecides, Look::squeezed, "~=AC(~"},
    {Kind::siemens, kDecides, Look::squeezed, "~=IC(~"},
    {Kind::siemens, kHalf, Look::squeezed, "T=\"~"},
    {Kind::siemens, kHalf, Look::block, "TRANS ~"},
    {Kind::siemens, kHalf, Look::block, "PROC @~"},
    {Kind::siemens, kHalf, Look::block, "~SUPA~"},
    {Kind::siemens, kHalf, Look::squeezed, "~CR=~"},
    {Kind::siemens, kHalf, Look::squeezed, "R#=~"},
    {Kind::siemens, kHalf, Look::squeezed, "~TURN=~"},
    {Kind::siemens, kHalf, Look::squeezed, "~SPOS=~"},
    {Kind::siemens, kHalf, Look::squeezed, "G4F#~"},
    // Source: OKUMA OSP, programming manuals.
    {Kind::okuma, kDecides, Look::first, "$@.MIN%"},
    {Kind::okuma, kDecides, Look::first, "$@.SUB%"},
    {Kind::okuma, kDecides, Look::first, "$@.SSB%"},
    {Kind::okuma, kDecides, Look::first, "$@.LIB%"},
    {Kind::okuma, kHalf, Look::block, "NOEX ~"},
    {Kind::okuma, kHalf, Look::block, "CALL O~"},
    {Kind::okuma, kHalf, Look::block, "RTS"},
    {Kind::winCnc, kDecides, Look::first, "[@ ~]"},
    {Kind::winCnc, kHalf, Look::squeezed, "G#[@]"},
    {Kind::winCnc, kHalf, Look::squeezed, "M#[@]"},
    {Kind::shopBot, kHalf, Look::squeezed, "M2,~"},
    {Kind::shopBot, kHalf, Look::squeezed, "M3,~"},
    {Kind::shopBot, kHalf, Look::squeezed, "MZ,~"},
    {Kind::shopBot, kHalf, Look::squeezed, "J2,~"},
    {Kind::shopBot, kHalf, Look::squeezed, "J3,~"},
    {Kind::shopBot, kHalf, Look::squeezed, "JZ,~"},
    {Kind::shopBot, kHalf, Look::squeezed, "MS,~"},
    {Kind::shopBot, kHalf, Look::squeezed, "TR,~"},
    // Source: FANUC, operator's manuals for lathes. Applies only if no block names Y or changes a tool by M6.
    {Kind::lathe, kDecides, Look::squeezed, "G92S#"},
    {Kind::lathe, kDecides, Look::squeezed, "~G50S#~"},
    {Kind::lathe, kHalf, Look::squeezed, "~G96S#~"},
    {Kind::lathe, kHalf, Look::squeezed, "G71U~R~"},
    {Kind::lathe, kHalf, Look::squeezed, "G71P#Q#~"},
    {Kind::lathe, kHalf, Look::squeezed, "G72W~R~"},
    {Kind::lathe, kHalf, Look::squeezed, "G72P#Q#~"},
    {Kind::lathe, kHalf, Look::squeezed, "G70P#Q#~"},
    {Kind::lathe, kHalf, Look::squeezed, "G73U~W~R~"},
    {Kind::lathe, kHalf, Look::squeezed, "T????"},
    {Kind::lathe, kHalf, Look::squeezed, "G0T????"},
    // Source: Marlin firmware, G-code index.
    {Kind::printer, kDecides, Look::line, ";FLAVOR:~"},
    {Kind::printer, kHalf, Look::squeezed, "M104S#~"},
    {Kind::printer, kHalf, Look::squeezed, "M109S#~"},
    {Kind::printer, kHalf, Look::squeezed, "M140S#~"},
    {Kind::printer, kHalf, Look::squeezed, "M190S#~"},
    {Kind::printer, kHalf, Look::squeezed, "G92E0~"},
    {Kind::printer, kHalf, Look::block, "G1 X~ Y~ E~"},
    {Kind::apt, kHalf, Look::block, "PARTNO~"},
    {Kind::apt, kHalf, Look::squeezed, "GOTO/~"},
    {Kind::apt, kHalf, Look::squeezed, "FEDRAT/~"},
    {Kind::apt, kHalf, Look::squeezed, "LOADTL/~"},
    {Kind::apt, kHalf, Look::squeezed, "SPINDL/~"},
    {Kind::apt, kHalf, Look::squeezed, "CUTTER/~"},
    {Kind::apt, kHalf, Look::squeezed, "FROM/~"},
    {Kind::apt, kHalf, Look::squeezed, "GODLTA/~"},
    // Source: Ucamco, The Gerber layer format specification.
    {Kind::gerber, kDecides, Look::line, "%FSLA~"},
    {Kind::gerber, kDecides, Look::line, "%FSTA~"},
    {Kind::gerber, kDecides, Look::line, "%MOMM\\*%~"},
    {Kind::gerber, kDecides, Look::line, "%MOIN\\*%~"},
    {Kind::gerber, kDecides, Look::line, "%ADD#~"},
    {Kind::gerber, kDecides, Look::line, "%TF.~"},
    {Kind::excellon, kHalf, Look::first, "M48"},
    {Kind::excellon, kDecides, Look::line, "FMAT,#"},
    {Kind::excellon, kHalf, Look::line, "METRIC"},
    {Kind::excellon, kHalf, Look::line, "METRIC,~"},
    {Kind::excellon, kHalf, Look::line, "INCH"},
    {Kind::excellon, kHalf, Look::line, "INCH,~"},
    {Kind::excellon, kHalf, Look::line, "T#C#.#~"},
    {Kind::excellon, kHalf, Look::line, "T#C.#~"},
    {Kind::hpgl, kDecides, Look::first, "IN;~"},
    {Kind::hpgl, kDecides, Look::first, "PA;~"},
    {Kind::hpgl, kHalf, Look::first, "SP#;~"},
    {Kind::hpgl, kHalf, Look::line, "PU#~;"},
    {Kind::hpgl, kHalf, Look::line, "PD#~;"},
    {Kind::hpgl, kHalf, Look::line, "PU;~"},
    {Kind::camotics, kMore, Look::line, "~\"RESOLUTION-MODE\":~"},
    {Kind::camotics, kMore, Look::line, "~\"NC-FILES\":~"},
    {Kind::job, kMore, Look::line, "~\"PROVEOUT\":~"},
    {Kind::json, kDecides, Look::first, "{\"~"},
    {Kind::json, kDecides, Look::first, "{ \"~"},
    {Kind::json, kDecides, Look::first, "[{~"},
    {Kind::json, kHalf, Look::first, "{"},
    {Kind::json, kHalf, Look::first, "["},
    {Kind::json, kHalf, Look::line, "\"~\":~"},
    {Kind::json, kHalf, Look::line, "\"~\" :~"},
    {Kind::svg, kMore, Look::line, "<SVG~"},
    {Kind::html, kMore, Look::first, "<!DOCTYPE HTML~"},
    {Kind::html, kMore, Look::first, "<HTML~"},
    {Kind::xml, kDecides, Look::first, "<\\?XML~"},
    {Kind::xml, kDecides, Look::first, "<!~"},
    {Kind::xml, kHalf, Look::first, "<@ ~"},
    {Kind::xml, kHalf, Look::line, "</@>"},
    {Kind::stl, kHalf, Look::first, "SOLID~"},
    {Kind::stl, kHalf, Look::line, "FACET NORMAL ~"},
    {Kind::stl, kHalf, Look::line, "ENDSOLID~"},
    {Kind::obj, kHalf, Look::line, "V ~ ~ ~"},
    {Kind::obj, kHalf, Look::line, "F # # #~"},
    {Kind::obj, kHalf, Look::line, "F #/~ #/~ #/~"},
    {Kind::ply, kHalf, Look::first, "PLY"},
    {Kind::ply, kHalf, Look::line, "ELEMENT VERTEX #"},
    {Kind::step, kDecides, Look::first, "ISO-10303-21;~"},
    {Kind::dxf, kHalf, Look::first, "0"},
    {Kind::dxf, kHalf, Look::first, "999"},
    {Kind::dxf, kHalf, Look::line, "SECTION"},
    {Kind::postScript, kDecides, Look::first, "%!PS~"},
    {Kind::pdf, kDecides, Look::first, "%PDF-~"},
    {Kind::richText, kDecides, Look::first, "{\\\\RTF~"},
};

} // namespace

const ForeignKindRow& rowOf(ForeignKind kind) {
    return kKinds[static_cast<std::size_t>(kind)];
}

std::span<const ForeignSign> foreignSigns() {
    return kSigns;
}

} // namespace proveout
