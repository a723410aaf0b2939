// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/scintilla_document.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include <Qsci/qsciscintillabase.h>

#include "core/base/utf8.h"

namespace proveout {

/// Scintilla's own interface; the order is that of its ILoader.h, which QScintilla does not install.
class ScintillaLoader {
public:
    virtual int Release() = 0;
    virtual int AddData(const char* data, std::ptrdiff_t length) = 0;
    virtual void* ConvertToDocument() = 0;

protected:
    ~ScintillaLoader() = default;
};

namespace {

// UBSan compares types by name and would not recognise Scintilla's class under this name.
#define PROVEOUT_OF_SCINTILLA __attribute__((no_sanitize("vptr")))

/// Bytes appended between two checks for a stop request. Scintilla's buffer grows by at least a sixth each
/// time.
constexpr std::size_t kSlice = std::size_t{16} << 20;
constexpr std::size_t kShownOfALine = 2000;

} // namespace

// Reserves no bytes here, because Scintilla would clear them on the UI thread.
ScintillaDocument::ScintillaDocument(const QsciScintillaBase& view)
    : m_loader(
          static_cast<ScintillaLoader*>(view.SendScintillaPtrResult(QsciScintillaBase::SCI_CREATELOADER))) {}

PROVEOUT_OF_SCINTILLA ScintillaDocument::~ScintillaDocument() {
    m_loader->Release();
}

bool ScintillaDocument::fill(const NcText& text, const std::stop_token& stop) {
    for (std::string_view run : text.runs()) {
        while (!run.empty()) {
            if (stop.stop_requested())
                return false;
            const std::string_view slice = run.substr(0, std::min(kSlice, run.size()));
            if (!add(slice))
                return false;
            run.remove_prefix(slice.size());
        }
    }
    return true;
}

bool ScintillaDocument::fillCutOff(const NcText& text, const std::stop_token& stop) {
    for (std::size_t line = 0; line < text.lineCount(); ++line) {
        const std::string_view bytes = text.line(line);
        const std::string_view shown = shortened(bytes, kShownOfALine);
        const bool added = add(shown) && (shown.size() == bytes.size() || add(" ...")) &&
                           (line + 1 == text.lineCount() || add("\n"));
        if (!added || stop.stop_requested())
            return false;
    }
    return true;
}

PROVEOUT_OF_SCINTILLA bool ScintillaDocument::add(std::string_view bytes) {
    return m_loader->AddData(bytes.data(), static_cast<std::ptrdiff_t>(bytes.size())) ==
           QsciScintillaBase::SC_STATUS_OK;
}

PROVEOUT_OF_SCINTILLA void ScintillaDocument::showIn(const QsciScintillaBase& view) const {
    view.SendScintilla(QsciScintillaBase::SCI_SETDOCPOINTER, 0UL, m_loader->ConvertToDocument());
}

} // namespace proveout
