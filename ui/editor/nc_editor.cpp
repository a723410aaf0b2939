// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/nc_editor.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QMimeData>
#include <QScrollBar>

#include "ui/look/theme.h"

namespace proveout {

namespace {

constexpr int kNumberMargin = 0;
constexpr int kProblemMargin = 1;
constexpr int kArrowMargin = 2;
constexpr int kArrowMarginWidth = 14;
constexpr int kTabWidth = 4;
constexpr int kBreakpoint = 0; // drawn below the arrow
constexpr int kCurrentArrow = 1;
constexpr int kCurrentBackground = 2;
constexpr int kBreakpointOff = 3;
constexpr int kCaretLineVeil = 12; ///< of 255
constexpr double kCurrentTint = 0.22;
constexpr std::size_t kMostColumns = 200;       ///< limit for the width that a panel requests
constexpr int kBesideText = 12;                 ///< px
constexpr std::size_t kBytesAtOnce = 1'000'000; ///< takes a few milliseconds

/// Mixes `share` of `b` into `a`. The result is opaque, because a translucent marker is not drawn behind
/// styled text.
QColor mixed(const QColor& a, const QColor& b, double share) {
    const auto mix = [share](int x, int y) { return static_cast<int>(x + share * (y - x)); };
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

unsigned long asWord(std::size_t value) {
    return static_cast<unsigned long>(value);
}

/// Keys that move the cursor or scroll the text; modifiers such as Shift alone do not count.
bool isNavigation(int key) {
    return key >= Qt::Key_Home && key <= Qt::Key_PageDown;
}

int scintillaLineEnd(LineEnd lineEnd) {
    switch (lineEnd) {
    case LineEnd::lf:
        return QsciScintilla::SC_EOL_LF;
    case LineEnd::crLf:
        return QsciScintilla::SC_EOL_CRLF;
    case LineEnd::cr:
        return QsciScintilla::SC_EOL_CR;
    }
    return QsciScintilla::SC_EOL_LF;
}

bool fill(ScintillaDocument& shown, const Document& document, const std::stop_token& stop) {
    return document.tooLongLine > 0 ? shown.fillCutOff(document.text, stop) : shown.fill(document.text, stop);
}

} // namespace

NcEditor::NcEditor(QWidget* parent)
    : ObservedScintilla(parent), m_highlighter(this), m_problems(*this, kProblemMargin) {
    setLexer(&m_highlighter);
    setUpMargins();
    setWrapMode(WrapNone);
    setAnnotationDisplay(AnnotationHidden); // otherwise loading a text would query each line
    setScrollWidthTracking(true);
    setScrollWidth(1);
    SendScintilla(SCI_SETCARETLINEVISIBLEALWAYS, 1UL);
    connect(&edits(), &TextEdits::made, this, &NcEditor::onEdit);
    connect(this, &QsciScintilla::modificationChanged, this, [this](bool modified) {
        if (!m_loading)
            emit savedStateChanged(modified);
    });
    connect(verticalScrollBar(), &QScrollBar::actionTriggered, this, &NcEditor::worked);
    adoptPalette();
}

void NcEditor::setUpMargins() {
    setMarginType(kNumberMargin, NumberMargin);
    setMarginMarkerMask(kNumberMargin, 0); // a marker that is drawn in a margin does not colour its line
    setMarginType(kArrowMargin, SymbolMargin);
    setMarginWidth(kArrowMargin, kArrowMarginWidth);
    setMarginMarkerMask(kArrowMargin, 1 << kCurrentArrow | 1 << kBreakpoint | 1 << kBreakpointOff);
    markerDefine(Circle, kBreakpoint);
    markerDefine(Circle, kBreakpointOff);
    for (const int margin : {kNumberMargin, kArrowMargin})
        setMarginSensitivity(margin, true);
    connect(this, &QsciScintilla::marginClicked, this,
            [this](int /*margin*/, int line) { emit marginChosen(line + 1); });
    markerDefine(RightTriangle, kCurrentArrow);
    markerDefine(Background, kCurrentBackground);
}

int NcEditor::widthOf(std::size_t columns) const {
    const std::string text(std::min(columns, kMostColumns), '8');
    int margins = 0;
    for (const int margin : {kNumberMargin, kProblemMargin, kArrowMargin})
        margins += marginWidth(margin);
    return static_cast<int>(SendScintilla(SCI_TEXTWIDTH, STYLE_DEFAULT, text.c_str())) + margins +
           verticalScrollBar()->sizeHint().width() + kBesideText;
}

void NcEditor::showDialect(DialectId dialect) {
    if (dialect == m_highlighter.dialect())
        return;
    m_highlighter.setDialect(dialect);
    SendScintilla(SCI_STARTSTYLING, 0UL); // what is visible is styled when it is painted or soon after
    viewport()->update();
}

void NcEditor::adoptPalette() {
    const QPalette colors = QApplication::palette();
    const MeaningColors meaning = meaningColors(colors);
    m_highlighter.adoptPalette();
    setLexer(&m_highlighter); // copies the colours into Scintilla's styles
    setPaper(colors.color(QPalette::Base));
    setCaretForegroundColor(colors.color(QPalette::Text));
    // Translucent, so that the line of the current block keeps its colour when the cursor is on it.
    QColor veil = colors.color(QPalette::Text);
    veil.setAlpha(kCaretLineVeil);
    setCaretLineBackgroundColor(veil);
    setCaretLineVisible(true);
    setSelectionBackgroundColor(colors.color(QPalette::Highlight));
    setSelectionForegroundColor(colors.color(QPalette::HighlightedText));
    setMarginsBackgroundColor(colors.color(QPalette::Window));
    setMarginsForegroundColor(colors.color(QPalette::PlaceholderText));
    setMarkerBackgroundColor(mixed(colors.color(QPalette::Base), meaning.accent, kCurrentTint),
                             kCurrentBackground);
    setMarkerBackgroundColor(meaning.accent, kCurrentArrow);
    setMarkerForegroundColor(meaning.accent, kCurrentArrow);
    setMarkerBackgroundColor(meaning.breakpoint, kBreakpoint);
    setMarkerForegroundColor(meaning.breakpoint, kBreakpoint);
    setMarkerBackgroundColor(colors.color(QPalette::Window), kBreakpointOff);
    setMarkerForegroundColor(meaning.breakpoint, kBreakpointOff);
    m_problems.adoptPalette();
}

void NcEditor::showBreakpoints(const std::vector<int>& on, const std::vector<int>& off) {
    markerDeleteAll(kBreakpoint);
    markerDeleteAll(kBreakpointOff);
    for (const int line : on)
        markerAdd(line - 1, kBreakpoint);
    for (const int line : off)
        markerAdd(line - 1, kBreakpointOff);
}

void NcEditor::load(const Document& document) {
    edits().discard();
    m_place.reset();
    m_filling.cancel();
    auto before = std::exchange(m_document, nullptr); // freeing it here would block the window
    auto next = std::make_shared<ScintillaDocument>(*this);
    if (document.text.size() <= kBytesAtOnce) {
        fill(*next, document, {});
        showDocument(std::move(next), document, document.readOnly);
        m_filling.start([before = std::move(before)](const NewestTask::Reply&) mutable { before.reset(); });
        return;
    }
    showDocument(std::make_shared<ScintillaDocument>(*this), document, true);
    m_isFilling = true;
    m_filling.start([this, before = std::move(before), next,
                     document](const NewestTask::Reply& reply) mutable {
        before.reset();
        const bool whole = fill(*next, document, reply.stop);
        reply.post([this, next, document, whole] {
            showDocument(next, document,
                         document.readOnly || !whole); // editing requires the complete text
        });
    });
}

void NcEditor::showDocument(std::shared_ptr<const ScintillaDocument> shown, const Document& document,
                            bool readOnly) {
    m_loading = true;
    shown->showIn(*this);
    m_document = std::move(shown);
    m_isFilling = false;
    setUtf8(document.utf8);
    SendScintilla(SCI_SETEOLMODE, static_cast<unsigned long>(scintillaLineEnd(document.lineEnd)));
    setTabWidth(kTabWidth);
    SendScintilla(SCI_SETUNDOCOLLECTION, 1UL);
    SendScintilla(SCI_SETSAVEPOINT);
    SendScintilla(SCI_GOTOPOS, 0UL);
    setReadOnly(readOnly);
    m_loading = false;
    m_currentLine = 0;
    m_values.reset();
    leaveWord();
    m_problems.clear();
    setMarginWidth(kNumberMargin,
                   QString(qMax(4, static_cast<int>(QString::number(lines()).size()) + 1), u'0'));
    emit textChanged();
    emit loaded();
    if (const auto place = std::exchange(m_place, std::nullopt))
        goTo(place->first, place->second);
}

void NcEditor::markSaved() {
    SendScintilla(SCI_SETSAVEPOINT);
}

void NcEditor::onEdit(const TextEdit& edit) {
    m_values.reset();
    leaveWord();
    if (m_loading)
        return;
    m_edited = true;
    emit worked();
    if (edit.linesAdded != 0) {
        const long line = SendScintilla(SCI_LINEFROMPOSITION, asWord(edit.offset));
        const long start = SendScintilla(SCI_POSITIONFROMLINE, static_cast<unsigned long>(line));
        emit linesMoved(static_cast<std::uint32_t>(line) + 1, static_cast<std::size_t>(start) == edit.offset,
                        edit.linesAdded);
    }
    emit edited(edit.offset, edit.removed, edit.inserted);
    emit textChanged();
}

void NcEditor::showCurrentLine(int line, bool follow) {
    if (line == m_currentLine)
        return;
    const int marked = std::exchange(m_currentLine, line) - 1;
    // Searches all lines only if an edit has moved the marker.
    const bool there = marked >= 0 && (markersAtLine(marked) & (1U << kCurrentArrow)) != 0;
    for (const int mark : {kCurrentArrow, kCurrentBackground}) {
        if (there)
            markerDelete(marked, mark);
        else if (marked >= 0)
            markerDeleteAll(mark);
    }
    if (line > 0) {
        markerAdd(line - 1, kCurrentArrow);
        markerAdd(line - 1, kCurrentBackground);
    }
    if (follow)
        revealLine(std::max(line, 1));
}

void NcEditor::revealCurrentLine() {
    revealLine(std::max(m_currentLine, 1));
}

void NcEditor::revealLine(int line) {
    const long first = SendScintilla(SCI_GETFIRSTVISIBLELINE);
    const long shown = SendScintilla(SCI_LINESONSCREEN);
    if (line - 1 >= first && line - 1 < first + shown - 1)
        return;
    SendScintilla(SCI_SETFIRSTVISIBLELINE, static_cast<unsigned long>(std::max(0L, line - 1 - shown / 3)));
}

void NcEditor::goTo(int line, int column) {
    emit worked();
    if (m_isFilling) {
        m_place = {line, column};
        return;
    }
    const int index = std::clamp(line - 1, 0, std::max(0, lines() - 1));
    const long begin = SendScintilla(SCI_POSITIONFROMLINE, static_cast<unsigned long>(index));
    const long end = SendScintilla(SCI_GETLINEENDPOSITION, static_cast<unsigned long>(index));
    SendScintilla(SCI_GOTOPOS, static_cast<unsigned long>(std::min(end, begin + std::max(0, column - 1))));
    revealLine(index + 1);
}

int NcEditor::caretLine() const {
    const long position = SendScintilla(SCI_GETCURRENTPOS);
    return static_cast<int>(SendScintilla(SCI_LINEFROMPOSITION, static_cast<unsigned long>(position))) + 1;
}

std::string_view NcEditor::textBytes() const {
    const auto* text = static_cast<const char*>(SendScintillaPtrResult(SCI_GETCHARACTERPOINTER));
    return {text, static_cast<std::size_t>(SendScintilla(SCI_GETLENGTH))};
}

std::string NcEditor::encoded(const QString& text) const {
    return (isUtf8() ? text.toUtf8() : text.toLatin1()).toStdString();
}

std::pair<std::size_t, std::size_t> NcEditor::selectedBytes() const {
    return {static_cast<std::size_t>(SendScintilla(SCI_GETSELECTIONSTART)),
            static_cast<std::size_t>(SendScintilla(SCI_GETSELECTIONEND))};
}

void NcEditor::selectBytes(std::size_t begin, std::size_t end) {
    emit worked();
    SendScintilla(SCI_SETSEL, asWord(begin), static_cast<long>(end));
}

void NcEditor::replaceBytes(std::size_t begin, std::size_t end, std::string_view text) {
    const long seen = SendScintilla(SCI_GETFIRSTVISIBLELINE);
    beginUndoAction();
    SendScintilla(SCI_SETTARGETRANGE, asWord(begin), static_cast<long>(end));
    SendScintilla(SCI_REPLACETARGET, asWord(text.size()), text.data());
    endUndoAction();
    edits().flush();
    SendScintilla(SCI_SETFIRSTVISIBLELINE, static_cast<unsigned long>(seen));
}

bool NcEditor::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        return showTip(viewport()->mapFrom(this, help->pos()), help->globalPos());
    }
    return ObservedScintilla::event(event);
}

void NcEditor::mousePressEvent(QMouseEvent* event) {
    emit worked();
    QsciScintilla::mousePressEvent(event);
}

void NcEditor::mouseReleaseEvent(QMouseEvent* event) {
    QsciScintilla::mouseReleaseEvent(event);
    // A click in the margins sets a breakpoint and does not move the cursor.
    if (event->button() == Qt::LeftButton && !hasSelectedText() && !m_problems.isInMargins(event->pos()))
        emit lineChosen(caretLine());
}

void NcEditor::keyPressEvent(QKeyEvent* event) {
    if (!event->text().isEmpty() || isNavigation(event->key()))
        emit worked();
    const int before = caretLine();
    m_edited = false;
    QsciScintilla::keyPressEvent(event);
    edits().flush();
    if (!m_edited && caretLine() != before)
        emit lineChosen(caretLine());
}

void NcEditor::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    menu.addActions(actions());
    menu.exec(event->globalPos());
}

void NcEditor::changeEvent(QEvent* event) {
    QsciScintilla::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::ApplicationPaletteChange)
        adoptPalette();
}

bool NcEditor::canInsertFromMimeData(const QMimeData* source) const {
    return !source->hasUrls() && QsciScintilla::canInsertFromMimeData(source);
}

} // namespace proveout
