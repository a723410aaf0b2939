// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"

namespace proveout {

/// An immutable NC text with its line index: a piece table over shared buffers, so that an edited copy shares
/// what did not change and can be interpreted while the user continues typing. Value type; copies are cheap
/// and may be read from any thread. Lines are split as in an editor (LF, CR LF, or a lone CR); a UTF-8 byte
/// order mark is skipped.
class NcText {
public:
    NcText();
    explicit NcText(std::string text);

    /// Reads a file. Errors: those of readFile(); UTF-16; binary content (id "nc-binary", at 1:1).
    [[nodiscard]] static Result<NcText> load(const std::filesystem::path& file,
                                             const WorkContext& context = {});

    [[nodiscard]] std::size_t size() const;      ///< bytes
    [[nodiscard]] std::size_t lineCount() const; ///< at least 1
    /// Line `index` (0-based) without its line end; valid as long as this object or a copy of it exists.
    [[nodiscard]] std::string_view line(std::size_t index) const;
    [[nodiscard]] std::string toString() const;
    /// The bytes of the text in order, as stored in memory; valid as long as this object or a copy of it
    /// exists.
    [[nodiscard]] std::vector<std::string_view> runs() const;

    /// Whether a UTF-8 byte order mark was skipped.
    [[nodiscard]] bool hadByteOrderMark() const;
    /// Index of the first line that ends with a lone CR; lineCount() if there is none, which is found
    /// quickly.
    [[nodiscard]] std::size_t firstLoneCr() const;

    /// A copy in which the bytes [offset, offset + removed) are replaced.
    [[nodiscard]] NcText replaced(std::size_t offset, std::size_t removed, std::string_view inserted) const;

    /// The number of lines at the beginning that are the same in both texts, including line ends. Fast if
    /// they share buffers.
    [[nodiscard]] std::size_t sameLines(const NcText& other) const;

private:
    struct State;
    std::shared_ptr<const State> m_state;
};

} // namespace proveout
