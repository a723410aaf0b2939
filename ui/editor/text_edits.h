// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include <QAccessible>
#include <QObject>
#include <Qsci/qsciscintilla.h>

namespace proveout {

/// Bytes [begin, end) of the text of a Scintilla view; valid until the text changes. Bytes on both sides of
/// the last edit are moved together first: ask for few.
[[nodiscard]] std::string_view bytesOf(const QsciScintillaBase& view, std::size_t begin, std::size_t end);
[[nodiscard]] std::size_t sizeOf(const QsciScintillaBase& view);

/// A part of the text was replaced by another one.
struct TextEdit {
    std::size_t offset = 0;
    std::size_t removed = 0;       ///< bytes
    std::string_view inserted{};   ///< valid until the text changes
    std::ptrdiff_t linesAdded = 0; ///< negative: removed
};

/// Tells of each edit of the text in a Scintilla view: when it is flushed, when the next edit begins, or at
/// the latest when events are handled. For screen readers, QScintilla counts all characters before an edit
/// when it is told that one was made, and before the caret at each update of a view with an accessible
/// interface: 0.3 s in 32 MB. So it is told, and the view has this interface, only while there is a screen
/// reader; without, this class is told that an edit begins, and looks afterwards. Thread: UI.
class TextEdits final : public QObject, private QAccessible::ActivationObserver {
    Q_OBJECT

public:
    /// Kept by `view`.
    explicit TextEdits(QsciScintillaBase& view);
    ~TextEdits() override;

    /// Tells of an edit that was made, if there is one.
    void flush();
    /// Does not tell of it: another text will be shown.
    void discard() { m_begun.reset(); }

signals:
    /// The text is as it is after this edit.
    void made(const TextEdit& edit);

private:
    void accessibilityActiveChanged(bool active) override;
    void begin(int position, int type, int length);
    [[nodiscard]] std::ptrdiff_t lines() const;

    /// An edit that has begun.
    struct Begun {
        std::size_t offset = 0;
        std::size_t removed = 0;
        std::size_t inserted = 0;
        std::size_t sizeBefore = 0;
        std::ptrdiff_t linesBefore = 0;
    };

    QsciScintillaBase& m_view;
    std::optional<Begun> m_begun;
    bool m_isQueued = false; ///< flush() will be called
};

/// A Scintilla view whose edits are told before the event or the command returns that made them.
class ObservedScintilla : public QsciScintilla {
    Q_OBJECT

public:
    explicit ObservedScintilla(QWidget* parent) : QsciScintilla(parent) { m_edits = new TextEdits(*this); }

    void undo() override { QsciScintilla::undo(), tell(); }
    void redo() override { QsciScintilla::redo(), tell(); }
    void cut() override { QsciScintilla::cut(), tell(); }
    void paste() override { QsciScintilla::paste(), tell(); }
    void removeSelectedText() override { QsciScintilla::removeSelectedText(), tell(); }

protected:
    bool event(QEvent* event) override {
        const bool used = QsciScintilla::event(event);
        tell();
        return used;
    }
    bool viewportEvent(QEvent* event) override {
        const bool used = QsciScintilla::viewportEvent(event);
        tell();
        return used;
    }
    [[nodiscard]] TextEdits& edits() const { return *m_edits; }

private:
    void tell() {
        if (m_edits != nullptr)
            m_edits->flush();
    }

    TextEdits* m_edits = nullptr; ///< set after the first events
};

} // namespace proveout
