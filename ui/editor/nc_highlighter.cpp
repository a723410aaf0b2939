// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/nc_highlighter.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

#include <QApplication>
#include <QFontDatabase>
#include <Qsci/qsciscintilla.h>

#include "core/nc/codes/codes.h"
#include "ui/look/theme.h"

namespace proveout {

namespace {

constexpr int kPointSize = 10;
constexpr double kLargestCode = 999;

bool isOneOf(char c, std::string_view set) {
    return set.find(c) != std::string_view::npos;
}

bool isLetter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// The end of the word whose letter is at `begin`: after its number, which spaces may precede.
std::size_t wordEnd(std::string_view line, std::size_t begin) {
    std::size_t end = begin + 1;
    for (std::size_t i = begin + 1; i < line.size(); ++i) {
        if (isOneOf(line[i], "0123456789.+-"))
            end = i + 1;
        else if (!isOneOf(line[i], " \t"))
            break;
    }
    return end;
}

/// Whether the interpreter supports a G or M word, e.g. "G01" or "g 38.2".
bool isSupportedCode(std::string_view word, DialectId dialect) {
    std::string digits(word.substr(1));
    std::erase_if(digits, [](char c) { return isOneOf(c, " \t"); });
    double number = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (read.ec != std::errc() || read.ptr != digits.data() + digits.size() || number < 0 ||
        number > kLargestCode)
        return false;
    const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(word.front())));
    const CodeRow* row = codesOf(dialect).find(letter, static_cast<int>(std::lround(number * 10)));
    return row != nullptr && row->supported();
}

NcStyle wordStyle(std::string_view word, DialectId dialect) {
    const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(word.front())));
    if (letter == 'G' || letter == 'M')
        return isSupportedCode(word, dialect) ? NcStyle::code : NcStyle::unknownCode;
    if (isOneOf(letter, "FST"))
        return NcStyle::machine;
    if (isOneOf(letter, "NO"))
        return NcStyle::label;
    return NcStyle::coordinate;
}

std::size_t commentEnd(std::string_view line, std::size_t begin) {
    if (line[begin] == ';')
        return line.size();
    const std::size_t close = line.find(')', begin);
    return close == std::string_view::npos ? line.size() : close + 1;
}

} // namespace

std::string styleLine(std::string_view line, DialectId dialect) {
    std::string styles(line.size(), static_cast<char>(NcStyle::plain));
    const auto fill = [&](std::size_t begin, std::size_t end, NcStyle style) {
        styles.replace(begin, end - begin, end - begin, static_cast<char>(style));
    };
    std::size_t i = 0;
    while (i < line.size()) {
        std::size_t end = i + 1;
        if (isOneOf(line[i], ";(")) {
            end = commentEnd(line, i);
            fill(i, end, NcStyle::comment);
        } else if (isLetter(line[i]) && end < line.size() && isLetter(line[end])) {
            while (end < line.size() && isLetter(line[end]))
                ++end;
            fill(i, end, NcStyle::label);
        } else if (isLetter(line[i])) {
            end = wordEnd(line, i);
            fill(i, end, wordStyle(line.substr(i, end - i), dialect));
        } else if (isOneOf(line[i], "%/")) {
            fill(i, end, NcStyle::label);
        }
        i = end;
    }
    return styles;
}

NcHighlighter::NcHighlighter(QObject* parent) : QsciLexerCustom(parent) {
    adoptPalette();
}

const char* NcHighlighter::language() const {
    return "NC";
}

QString NcHighlighter::description(int style) const {
    // Scintilla asks for style names until it gets an empty one; the names are not shown anywhere.
    return style < kNcStyleCount ? QString::number(style) : QString();
}

void NcHighlighter::setEditor(QsciScintilla* editor) {
    QsciLexerCustom::setEditor(editor);
    if (editor != nullptr)
        editor->SendScintilla(QsciScintilla::SCI_SETIDLESTYLING,
                              static_cast<unsigned long>(QsciScintilla::SC_IDLESTYLING_TOVISIBLE));
}

void NcHighlighter::styleText(int start, int end) {
    QsciScintilla* view = editor();
    const long firstLine =
        view->SendScintilla(QsciScintilla::SCI_LINEFROMPOSITION, static_cast<unsigned long>(start));
    const long from =
        view->SendScintilla(QsciScintilla::SCI_POSITIONFROMLINE, static_cast<unsigned long>(firstLine));
    std::string text(static_cast<std::size_t>(end - from) + 1, '\0'); // Scintilla appends a zero
    view->SendScintilla(QsciScintilla::SCI_GETTEXTRANGE, from, static_cast<long>(end), text.data());
    text.pop_back();
    std::string styles;
    styles.reserve(text.size());
    while (styles.size() < text.size()) {
        const std::size_t begin = styles.size();
        const std::size_t lineEnd = std::min(text.find_first_of("\r\n", begin), text.size() - 1);
        styles += styleLine(std::string_view(text).substr(begin, lineEnd + 1 - begin), m_dialect);
    }
    startStyling(static_cast<int>(from));
    view->SendScintilla(QsciScintilla::SCI_SETSTYLINGEX, static_cast<unsigned long>(styles.size()),
                        styles.data());
}

void NcHighlighter::adoptPalette() {
    const QPalette palette = QApplication::palette();
    const MeaningColors colors = meaningColors(palette);
    const std::array<QColor, kNcStyleCount> inks{palette.color(QPalette::Text),
                                                 colors.comment,
                                                 colors.word,
                                                 colors.error,
                                                 colors.coordinate,
                                                 colors.toolChange,
                                                 palette.color(QPalette::PlaceholderText)};
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    font.setPointSize(kPointSize);
    setDefaultFont(font);
    setDefaultColor(palette.color(QPalette::Text));
    setDefaultPaper(palette.color(QPalette::Base));
    for (int style = 0; style < kNcStyleCount; ++style) {
        QFont styled = font;
        styled.setBold(style == static_cast<int>(NcStyle::code));
        styled.setItalic(style == static_cast<int>(NcStyle::comment));
        setFont(styled, style);
        setColor(inks[static_cast<std::size_t>(style)], style);
        setPaper(palette.color(QPalette::Base), style);
    }
}

} // namespace proveout
