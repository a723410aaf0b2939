// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/tool_comment_words.h"

#include <algorithm>
#include <unordered_map>

namespace proveout {

namespace {

using enum CommentField;

constexpr LabelRow kLabelWords[] = {
    {"T", toolNumber, true},
    {"TOOL", toolNumber},
    {"TOOL NO", toolNumber},
    {"TOOL NR", toolNumber},
    {"TOOL NUM", toolNumber},
    {"TOOL NUMBER", toolNumber},
    {"TURRET NO", toolNumber},
    {"WERKZEUG", toolNumber},
    {"WERKZEUG NR", toolNumber},
    {"OUTIL", toolNumber},
    {"UTENSILE", toolNumber},
    {"HERRAMIENTA", toolNumber},
    {"NARZEDZIE", toolNumber},
    {"ИНСТРУМЕНТ", toolNumber},

    {"D", diameter},
    {"Ø", diameter},
    {"DIA", diameter},
    {"DIAM", diameter},
    {"DIAMETER", diameter},
    {"DURCHMESSER", diameter},
    {"DIAMETRE", diameter},
    {"DIAMÈTRE", diameter},
    {"DIAMETRO", diameter},
    {"DIÁMETRO", diameter},
    {"SREDNICA", diameter},
    {"ДИАМЕТР", diameter},

    {"TOOL D", toolDiameter},
    {"TOOL DIA", toolDiameter},
    {"TOOL DIAM", toolDiameter},
    {"TOOL DIAMETER", toolDiameter},
    {"TOOLDIA", toolDiameter},
    {"TOOL SIZE", toolDiameter},
    {"TOOL MILL", toolDiameter},
    {"TOOL DRILL", toolDiameter},
    {"TOOL PATH DIAMETER", toolDiameter},
    {"CUTTER DIA", toolDiameter},
    {"CUTTER DIAMETER", toolDiameter},
    {"CUTTING DIAMETER", toolDiameter},
    {"BIT DIA", toolDiameter},
    {"BIT DIAMETER", toolDiameter},
    {"BIT SIZE", toolDiameter},
    {"MILL DIA", toolDiameter},
    {"MILL DIAMETER", toolDiameter},
    {"ENDMILL DIA", toolDiameter},
    {"ENDMILL DIAMETER", toolDiameter},
    {"DRILL DIA", toolDiameter},
    {"DRILL DIAMETER", toolDiameter},
    {"DRILL SIZE", toolDiameter},
    {"FLUTE", toolDiameter, true},
    {"TOOL RADIUS", toolRadius},
    {"CUTTER RADIUS", toolRadius},

    {"CR", cornerRadius},
    {"R", cornerRadius, true},
    {"CORNER R", cornerRadius},
    {"CORNER RAD", cornerRadius},
    {"CORNER RADIUS", cornerRadius},
    {"RADIUS", cornerRadius, true},
    {"TORUS RADIUS", cornerRadius},
    {"ECKENRADIUS", cornerRadius},

    {"TAPER", sideAngle},
    {"TAPER ANGLE", sideAngle},
    {"SIDE ANGLE", sideAngle},
    {"ANGLE", includedAngle},
    {"TIP ANGLE", includedAngle},
    {"POINT ANGLE", includedAngle},
    {"INCLUDED ANGLE", includedAngle},

    {"TIP DIA", tipDiameter},
    {"TIP DIAMETER", tipDiameter},

    {"FLUTE LENGTH", fluteLength},
    {"FLUTE LEN", fluteLength},
    {"CUTTING LENGTH", fluteLength},
    {"LOC", fluteLength},

    {"M", threadSize, true},
    {"H", height, true},

    {"DIA OFF", notOfCutter},
    {"DIA OFFSET", notOfCutter},
    {"DIAMETER OFF", notOfCutter},
    {"DIAMETER OFFSET", notOfCutter},
    {"SHANK DIA", notOfCutter},
    {"SHANK DIAMETER", notOfCutter},
    {"SHAFT DIAMETER", notOfCutter},
    {"HOLDER DIAMETER", notOfCutter},
    {"HOLE DIA", notOfCutter},
    {"HOLE DIAMETER", notOfCutter},
    {"THREAD DIAMETER", notOfCutter},
    {"CORNER RADIUS COMPENSATION", notOfCutter},
    {"CUTTER RADIUS COMPENSATION", notOfCutter},
    {"CUTTER DIAMETER COMPENSATION", notOfCutter},
    {"TOOL LENGTH", notOfCutter},
    {"TOOL LEN", notOfCutter},
};

/// The first matching row counts, so a more specific row must come before a more general one.
constexpr ShapeRow kShapeWords[] = {
    {"PROBE", ""},
    {"PROBING", ""},
    {"EDGE FINDER", ""},
    {"BORING BAR", ""},
    {"BORING HEAD", ""},

    {"LOLLIPOP", "lollipop"},
    {"DOVETAIL", "dovetail"},
    {"SCHWALBENSCHWANZ", "dovetail"},
    {"T SLOT", "tslot"},
    {"TSLOT", "tslot"},
    {"SLOT MILL", "tslot"},
    {"KEYSEAT", "tslot"},
    {"WOODRUFF", "tslot"},
    {"THREAD MILL", "threadmill"},
    {"THREADMILL", "threadmill"},
    {"GEWINDEFRÄSER", "threadmill"},
    {"GEWINDEFRAESER", "threadmill"},
    {"TAP", "tap"},
    {"GEWINDEBOHRER", "tap"},
    {"REAMER", "reamer"},
    {"REIBAHLE", "reamer"},
    {"SPOT DRILL", "spot"},
    {"SPOTDRILL", "spot"},
    {"SPOTTING DRILL", "spot"},
    {"NC DRILL", "spot"},
    {"CENTER DRILL", "centre"},
    {"CENTRE DRILL", "centre"},
    {"CENTERDRILL", "centre"},
    {"ZENTRIERBOHRER", "centre"},
    {"CHAMFER", "chamfer"},
    {"CHAMFERING", "chamfer"},
    {"CHAMFERMILL", "chamfer"},
    {"COUNTERSINK", "chamfer"},
    {"COUNTER SINK", "chamfer"},
    {"SENKER", "chamfer"},
    {"FASENFRÄSER", "chamfer"},
    {"FASENFRAESER", "chamfer"},
    {"V BIT", "cone"},
    {"VBIT", "cone"},
    {"V CUTTER", "cone"},
    {"V CARVE", "cone"},
    {"VCARVE", "cone"},
    {"VEE", "cone"},
    {"CONICAL", "cone"},
    {"CONICALCUTTER", "cone"},
    {"ENGRAVE", "cone"},
    {"ENGRAVER", "cone"},
    {"ENGRAVING", "cone"},
    {"GRAVURSTICHEL", "cone"},
    {"TAPERED BALL", "taperball"},
    {"TAPER BALL", "taperball"},
    {"BALL TAPERED", "taperball"},
    {"TAPERED", "taper"},
    {"TAPER MILL", "taper"},
    {"TAPER END MILL", "taper"},
    {"TAPER ENDMILL", "taper"},
    {"FACE MILL", "face"},
    {"FACEMILL", "face"},
    {"SHELL MILL", "face"},
    {"PLANFRÄSER", "face"},
    {"PLANFRAESER", "face"},
    {"MESSERKOPF", "face"},
    {"ТОРЦЕВАЯ", "face"},
    {"BALL", "ball"},
    {"BALLNOSE", "ball"},
    {"BALLEND", "ball"},
    {"BALLMILL", "ball"},
    {"SPHERICAL", "ball"},
    {"SPHERICALCUTTER", "ball"},
    {"KUGEL", "ball"},
    {"KUGELFRÄSER", "ball"},
    {"KUGELFRAESER", "ball"},
    {"KULISTA", "ball"},
    {"KULOVA", "ball"},
    {"HEMISPHERIQUE", "ball"},
    {"SFERICA", "ball"},
    {"СФЕРИЧЕСКАЯ", "ball"},
    {"BULL", "bull"},
    {"BULLNOSE", "bull"},
    {"TORUS", "bull"},
    {"TORUSFRÄSER", "bull"},
    {"TORUSFRAESER", "bull"},
    {"TOROIDAL", "bull"},
    {"TOROIDALCUTTER", "bull"},
    {"TORIC", "bull"},
    {"TOTAL DRILLS", "drill"},
    {"DRILL", "drill"},
    {"CHAMDRILL", "drill"},
    {"TWISTDRILL", "drill"},
    {"BOHRER", "drill"},
    {"SPIRALBOHRER", "drill"},
    {"WIERTLO", "drill"},
    {"FORET", "drill"},
    {"BROCA", "drill"},
    {"TALADRAR", "drill"},
    {"СВЕРЛО", "drill"},
    {"FLAT", "flat"},
    {"CYLINDRICAL", "flat"},
    {"CYLINDRICALCUTTER", "flat"},
    {"END MILL", "flat"},
    {"ENDMILL", "flat"},
    {"EM", "flat"},
    {"TYPE END", "flat"},
    {"SCHAFTFRÄSER", "flat"},
    {"SCHAFTFRAESER", "flat"},
    {"ROUGHER", "flat"},
    {"UPCUT", "flat"},
    {"DOWNCUT", "flat"},
};

constexpr std::string_view kToolWords[] = {
    "TC",   "TOOL",   "CUTTER", "BIT",   "MILL",     "ROUTER", "FREZA", "FRÄSER", "FRAESER",
    "FREZ", "FRAISE", "FRESA",  "FREES", "WERKZEUG", "ФРЕЗА",  "刀具",  "铣刀",
};

constexpr std::string_view kOtherThings[] = {
    "HOLE",      "HOLES",   "BOLT",      "STOCK",  "PART",  "BLANK",     "WORKPIECE", "MATERIAL",
    "CIRCLE",    "CIRCLES", "BOSS",      "THREAD", "DEPTH", "STEP",      "STEPOVER",  "STEPDOWN",
    "PASS",      "HEIGHT",  "DISTANCE",  "FEED",   "SPEED", "NOZZLE",    "FILAMENT",  "TRACK",
    "ALLOWANCE", "BORE",    "TOLERANCE", "OFFSET", "SHANK", "DEVIATION", "THICKNESS",
};

/// Whether the words of a row are at token `at`, one token each. Signs between them do not matter.
bool matchAt(std::string_view words, std::span<const CommentToken> tokens, std::size_t at) {
    while (!words.empty()) {
        const std::string_view word = words.substr(0, words.find(' '));
        if (at == tokens.size() || tokens[at].word != word)
            return false;
        ++at;
        words.remove_prefix(std::min(word.size() + 1, words.size()));
    }
    return true;
}

/// The rows of a table by their first word.
template<class Row>
class RowsByWord {
public:
    explicit RowsByWord(std::span<const Row> rows) {
        for (const Row& row : rows)
            m_rows.emplace(row.words.substr(0, row.words.find(' ')), &row);
    }
    /// Calls `visit(row)` for every row whose words are at token `at`.
    template<class Visitor>
    void at(std::span<const CommentToken> tokens, std::size_t at, Visitor&& visit) const {
        const auto [first, last] = m_rows.equal_range(tokens[at].word);
        for (auto entry = first; entry != last; ++entry)
            if (matchAt(entry->second->words, tokens, at))
                visit(*entry->second);
    }

private:
    std::unordered_multimap<std::string_view, const Row*> m_rows;
};

} // namespace

std::size_t wordCount(std::string_view words) {
    return 1 + static_cast<std::size_t>(std::ranges::count(words, ' '));
}

const LabelRow* labelAt(std::span<const CommentToken> tokens, std::size_t at) {
    static const RowsByWord<LabelRow> kRows(kLabelWords);
    const LabelRow* longest = nullptr;
    kRows.at(tokens, at, [&longest](const LabelRow& row) {
        if (longest == nullptr || row.words.size() > longest->words.size())
            longest = &row;
    });
    return longest;
}

ShapePlace shapeIn(std::span<const CommentToken> tokens) {
    static const RowsByWord<ShapeRow> kRows(kShapeWords);
    ShapePlace best;
    for (std::size_t at = 0; at < tokens.size(); ++at)
        kRows.at(tokens, at, [&](const ShapeRow& row) {
            if (best.row == nullptr || &row < best.row)
                best = {&row, at, at + wordCount(row.words) - 1};
        });
    return best;
}

bool namesTool(std::string_view word) {
    return std::ranges::find(kToolWords, word) != std::end(kToolWords);
}

bool namesSomethingElse(std::string_view word) {
    return std::ranges::find(kOtherThings, word) != std::end(kOtherThings);
}

} // namespace proveout
