// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <string_view>

#include "core/nc/text/nc_text.h"

class QsciScintillaBase;

namespace proveout {

class ScintillaLoader;

/// A document of Scintilla, which can be filled before a view shows it (SCI_CREATELOADER in the manual of
/// Scintilla). Made and shown on the UI thread. While no view shows it, it may be filled and destroyed on any
/// thread, one at a time: its count of owners is no atomic. Once it is shown, it belongs to the UI thread
/// until the view has another one.
class ScintillaDocument {
public:
    /// An empty one, without undo history and with Scintilla's default settings.
    explicit ScintillaDocument(const QsciScintillaBase& view);
    ScintillaDocument(const ScintillaDocument&) = delete;
    ScintillaDocument& operator=(const ScintillaDocument&) = delete;
    ~ScintillaDocument();

    /// Appends a text. False where memory was short, or where it was to stop: then its rest is missing.
    bool fill(const NcText& text, const std::stop_token& stop = {});
    /// The same of a text with lines that are too long to be laid out: where a line is cut off, dots follow.
    bool fillCutOff(const NcText& text, const std::stop_token& stop = {});
    /// In place of the one that the view shows.
    void showIn(const QsciScintillaBase& view) const;

private:
    bool add(std::string_view bytes);

    ScintillaLoader* m_loader; ///< one of the owners that the document counts
};

} // namespace proveout
