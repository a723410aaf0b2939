// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/text_edits.h"

#include <utility>

#include <QAccessibleWidget>
#include <Qsci/qsciscintillabase.h>

namespace proveout {

namespace {

constexpr int kBefore = QsciScintillaBase::SC_MOD_BEFOREINSERT | QsciScintillaBase::SC_MOD_BEFOREDELETE;
constexpr int kAfter = QsciScintillaBase::SC_MOD_INSERTTEXT | QsciScintillaBase::SC_MOD_DELETETEXT;

/// What a view is without a screen reader: QScintilla's own interface is made when there is one.
QAccessibleInterface* plainInterface(const QString& /*className*/, QObject* object) {
    auto* view = qobject_cast<QsciScintillaBase*>(object);
    return view == nullptr || QAccessible::isActive()
               ? nullptr
               : new QAccessibleWidget(view, QAccessible::EditableText);
}

} // namespace

std::string_view bytesOf(const QsciScintillaBase& view, std::size_t begin, std::size_t end) {
    const long place = view.SendScintilla(QsciScintillaBase::SCI_GETRANGEPOINTER,
                                          static_cast<unsigned long>(begin), static_cast<long>(end - begin));
    return {reinterpret_cast<const char*>(place), end - begin}; // NOLINT(performance-no-int-to-ptr)
}

std::size_t sizeOf(const QsciScintillaBase& view) {
    return static_cast<std::size_t>(view.SendScintilla(QsciScintillaBase::SCI_GETLENGTH));
}

TextEdits::TextEdits(QsciScintillaBase& view) : QObject(&view), m_view(view) {
    QAccessible::installFactory(plainInterface);
    QAccessible::installActivationObserver(this);
    accessibilityActiveChanged(QAccessible::isActive());
    connect(
        &view, &QsciScintillaBase::SCN_MODIFIED, this,
        [this](int position, int type, const char* /*text*/, int length) { begin(position, type, length); });
}

TextEdits::~TextEdits() {
    QAccessible::removeActivationObserver(this);
}

void TextEdits::accessibilityActiveChanged(bool active) {
    if (active) // the next one is QScintilla's
        QAccessible::deleteAccessibleInterface(
            QAccessible::uniqueId(QAccessible::queryAccessibleInterface(&m_view)));
    m_view.SendScintilla(QsciScintillaBase::SCI_SETMODEVENTMASK,
                         static_cast<unsigned long>(active ? kBefore | kAfter : kBefore));
}

void TextEdits::begin(int position, int type, int length) {
    if ((type & kBefore) == 0)
        return;
    flush();
    const bool isInserted = (type & QsciScintillaBase::SC_MOD_BEFOREINSERT) != 0;
    const auto size = static_cast<std::size_t>(length);
    m_begun = Begun{.offset = static_cast<std::size_t>(position),
                    .removed = isInserted ? 0 : size,
                    .inserted = isInserted ? size : 0,
                    .sizeBefore = sizeOf(m_view),
                    .linesBefore = lines()};
    if (!m_isQueued)
        QMetaObject::invokeMethod(
            this,
            [this] {
                m_isQueued = false;
                flush();
            },
            Qt::QueuedConnection);
    m_isQueued = true;
}

void TextEdits::flush() {
    const auto edit = std::exchange(m_begun, std::nullopt);
    if (!edit || sizeOf(m_view) + edit->removed != edit->sizeBefore + edit->inserted)
        return; // or it was not made, for lack of memory
    const std::string_view inserted = bytesOf(m_view, edit->offset, edit->offset + edit->inserted);
    emit made({edit->offset, edit->removed, inserted, lines() - edit->linesBefore});
}

std::ptrdiff_t TextEdits::lines() const {
    return m_view.SendScintilla(QsciScintillaBase::SCI_GETLINECOUNT);
}

} // namespace proveout
