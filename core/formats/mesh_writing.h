// SPDX-License-Identifier: GPL-3.0-or-later
// Common code of the mesh writers. Internal to this library.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/text.h"
#include "core/base/work_context.h"
#include "core/decimation/solid/solid.h"
#include "core/formats/mesh_files.h"

namespace proveout {

/// Refuse meshes that no mesh file can hold: an empty mesh; coordinates that are not finite.
[[nodiscard]] Result<void> checkNotEmpty(const std::filesystem::path& file, const TriangleMesh& mesh);
[[nodiscard]] Result<void> checkFinite(const std::filesystem::path& file, const TriangleMesh& mesh);
/// Refuses coordinates that single precision cannot hold, and those that are not finite.
[[nodiscard]] Result<void> checkSinglePrecision(const std::filesystem::path& file, const TriangleMesh& mesh);

/// Appends the shortest decimal that reads back as the same number, with a decimal point in every locale.
template<class Number>
void appendNumber(std::string& out, Number value) {
    constexpr std::size_t kLongest = 32;
    const std::size_t start = out.size();
    out.resize(start + kLongest);
    out.resize(static_cast<std::size_t>(
        std::to_chars(out.data() + start, out.data() + out.size(), value).ptr - out.data()));
}

/// Splits a mesh into batches of text (or bytes), and checks between them whether to stop. Keeps references
/// to its arguments.
class MeshBatches {
public:
    /// `items`: the total number of items of all passes, for the progress.
    MeshBatches(const std::filesystem::path& file, std::size_t items, const WorkContext& context)
        : m_file(file), m_items(items), m_context(context) {}

    /// Calls append(std::string&, item) for each item, and `out.write` with the result. Error: stopped.
    template<class Item, class Append, class Out>
    Result<void> pass(const std::vector<Item>& items, Out& out, Append&& append) {
        for (std::size_t begin = 0; begin < items.size(); begin += kBatch) {
            if (m_context.stopped())
                return cancelled();
            m_context.report(static_cast<double>(m_done) / static_cast<double>(m_items));
            const std::size_t end = std::min(begin + kBatch, items.size());
            m_text.clear();
            for (std::size_t i = begin; i < end; ++i)
                append(m_text, items[i]);
            out.write(std::string_view(m_text));
            m_done += end - begin;
        }
        return {};
    }

private:
    /// Items between two checks of the context: about a millisecond of work.
    static constexpr std::size_t kBatch = 8192;

    [[nodiscard]] tl::unexpected<Diagnostics> cancelled() const;

    const std::filesystem::path& m_file;
    std::size_t m_items;
    const WorkContext& m_context;
    std::size_t m_done = 0;
    std::string m_text;
};

/// Calls body(out) to write into a file that was just opened, and commits it. If the file could not be
/// opened, no work is done; if it fails later, all bytes are still passed to it, so that its message can say
/// how many are needed.
template<class Out, class Body>
[[nodiscard]] Result<WrittenFile> writeWhole(Out& out, const TriangleMesh& mesh, const WorkContext& context,
                                             Body&& body) {
    if (!out.failed())
        if (Result<void> done = body(out); !done)
            return tl::unexpected(std::move(done.error()));
    if (Result<void> done = out.commit(); !done)
        return tl::unexpected(std::move(done.error()));
    context.report(1);
    return WrittenFile{mesh.triangles.size(), out.bytesWritten()};
}

} // namespace proveout
