// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <Qsci/qscilexercustom.h>

#include "core/nc/text/dialect.h"

namespace proveout {

/// The styles of NC text, as Scintilla's style numbers.
enum class NcStyle : char {
    plain,
    comment,
    code,        ///< a supported G or M word
    unknownCode, ///< an unsupported G or M word
    coordinate,  ///< axis, arc and other words with a value
    machine,     ///< F, S, T
    label,       ///< N, O, %, block delete, keywords such as IF and sub
};
inline constexpr int kNcStyleCount = 7;

/// The style of every byte of one line; comments do not cross lines.
[[nodiscard]] std::string styleLine(std::string_view line, DialectId dialect);

/// Colours the words of NC text. Set it before a text is loaded: Scintilla then styles no more than the text
/// up to the visible part, and a long one in the idle time of the window, so that its colours come later.
class NcHighlighter final : public QsciLexerCustom {
    Q_OBJECT

public:
    explicit NcHighlighter(QObject* parent = nullptr);

    [[nodiscard]] const char* language() const override;
    [[nodiscard]] QString description(int style) const override;
    void setEditor(QsciScintilla* editor) override;
    void styleText(int start, int end) override;
    /// Uses the colours of the application's palette.
    void adoptPalette();
    /// The dialect whose codes are coloured as supported, from the next styling on.
    [[nodiscard]] DialectId dialect() const { return m_dialect; }
    void setDialect(DialectId dialect) { m_dialect = dialect; }

private:
    DialectId m_dialect = DialectId::linuxcnc;
};

} // namespace proveout
