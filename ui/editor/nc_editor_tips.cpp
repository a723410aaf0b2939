// SPDX-License-Identifier: GPL-3.0-or-later
// The tooltip of the word under the mouse.
#include <algorithm>
#include <utility>

#include <QEvent>
#include <QToolTip>

#include "ui/editor/nc_editor.h"
#include "ui/editor/word_tip.h"

namespace proveout {

namespace {

/// Escapes the text, because the sentences contain words of the user's file.
QString asHtml(const QString& text) {
    return text.toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
}

} // namespace

bool NcEditor::showTip(QPoint place, QPoint globalPlace) {
    const QString problems = m_problems.tipAt(place);
    auto word = wordAt(place);
    if (!word)
        leaveWord();
    if (problems.isEmpty() && !word) {
        QToolTip::hideText();
        return false;
    }
    if (!word) {
        QToolTip::showText(globalPlace, asHtml(problems), this);
        return true;
    }
    m_tip = Tip{problems, std::move(*word), globalPlace};
    showWordTip();
    if (!m_values || m_values->line != m_tip->word.line)
        emit valuesWanted(m_tip->word.line);
    return true;
}

/// Shows what the word under the mouse means and, once known, its value there.
void NcEditor::showWordTip() {
    const WordHelp& help = m_tip->word.help;
    QString tip = m_tip->problems;
    if (!tip.isEmpty())
        tip += QStringLiteral("\n\n");
    tip += readableHelp(help, m_highlighter.dialect());
    const bool known = m_values && m_values->line == m_tip->word.line;
    if (const QString values = known ? readableValues(help, *m_values) : QString(); !values.isEmpty())
        tip += u'\n' + values;
    QToolTip::showText(m_tip->place, asHtml(tip), viewport(), m_tip->word.place);
}

void NcEditor::showValues(std::shared_ptr<const LineValues> values) {
    m_values = std::move(values);
    // A closed tooltip must not reappear when its values arrive late.
    if (m_values && m_tip && m_tip->word.line == m_values->line && QToolTip::isVisible())
        showWordTip();
}

void NcEditor::leaveWord() {
    if (!m_tip)
        return;
    m_tip.reset();
    emit valuesUnwanted();
}

std::optional<NcEditor::PointedWord> NcEditor::wordAt(QPoint place) const {
    const long position = SendScintilla(SCI_POSITIONFROMPOINTCLOSE, static_cast<unsigned long>(place.x()),
                                        static_cast<long>(place.y()));
    if (position < 0)
        return {};
    const long line = SendScintilla(SCI_LINEFROMPOSITION, static_cast<unsigned long>(position));
    const long begin = SendScintilla(SCI_POSITIONFROMLINE, static_cast<unsigned long>(line));
    const long end = SendScintilla(SCI_GETLINEENDPOSITION, static_cast<unsigned long>(line));
    const std::string_view text =
        textBytes().substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
    auto help = helpAt(text, static_cast<std::size_t>(position - begin), m_highlighter.dialect());
    if (!help)
        return {};
    const auto at = [&](unsigned int message, std::size_t index) {
        return static_cast<int>(SendScintilla(message, 0UL, begin + static_cast<long>(index)));
    };
    const QPoint corner(at(SCI_POINTXFROMPOSITION, help->begin), at(SCI_POINTYFROMPOSITION, help->begin));
    const int height = static_cast<int>(SendScintilla(SCI_TEXTHEIGHT, static_cast<unsigned long>(line)));
    const QSize size(std::max(1, at(SCI_POINTXFROMPOSITION, help->end) - corner.x()), height);
    return PointedWord{std::move(*help), static_cast<std::uint32_t>(line + 1), QRect(corner, size)};
}

bool NcEditor::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::Leave)
        leaveWord();
    return ObservedScintilla::viewportEvent(event);
}

} // namespace proveout
