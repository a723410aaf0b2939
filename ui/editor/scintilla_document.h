// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <string_view>

#include "core/nc/text/nc_text.h"

class QsciScintillaBase;

namespace proveout {

class ScintillaLoader;

/// A Scintilla document, which can be filled before a view shows it (see SCI_CREATELOADER in the Scintilla
/// manual). Created and shown on the UI thread. Until a view shows it, it may be filled and destroyed on any
/// thread, one at a time, because its reference count is not atomic. Once shown, it belongs to the UI thread
/// until the view has another one.
class ScintillaDocument {
public:
    /// An empty document, without undo history and with Scintilla's default settings.
    explicit ScintillaDocument(const QsciScintillaBase& view);
    ScintillaDocument(const ScintillaDocument&) = delete;
    ScintillaDocument& operator=(const ScintillaDocument&) = delete;
    ~ScintillaDocument();

    /// Appends a text. False if memory was insufficient or a stop was requested: the rest of the text is
    /// missing then.
    bool fill(const NcText& text, const std::stop_token& stop = {});
    /// The same for a text with lines that are too long to be laid out: they are cut off and end in dots.
    bool fillCutOff(const NcText& text, const std::stop_token& stop = {});
    /// Replaces the document that the view shows.
    void showIn(const QsciScintillaBase& view) const;

private:
    bool add(std::string_view bytes);

    ScintillaLoader* m_loader; ///< one of the references that the document counts
};

} // namespace proveout
