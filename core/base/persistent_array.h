// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace proveout {

/// An array whose copies share what they have in common: copying costs one pointer per 256 elements, and
/// writing an element copies its chunk of 256 once per copy. It carries snapshots of the simulation (tiles,
/// region meshes, rows of statistics) to other threads. Value type. One thread writes an object; other
/// threads read *copies* of it, never the object itself.
template<class T>
class PersistentArray {
public:
    static constexpr std::size_t kChunkSize = 256;

    PersistentArray() = default;
    PersistentArray(const PersistentArray& other)
        : m_chunks(other.m_chunks), m_owned(other.m_chunks.size(), false), m_size(other.m_size) {
        // From now on the chunks are shared, for the copied object too. A copy owns nothing until it is
        // written, so copying copies only reads: several threads may do that at once.
        if (other.m_ownsSome) {
            other.m_owned.assign(other.m_chunks.size(), false);
            other.m_ownsSome = false;
        }
    }
    PersistentArray(PersistentArray&&) noexcept = default;
    PersistentArray& operator=(const PersistentArray& other) {
        if (this != &other)
            *this = PersistentArray(other);
        return *this;
    }
    PersistentArray& operator=(PersistentArray&&) noexcept = default;
    ~PersistentArray() = default;

    explicit PersistentArray(std::size_t size, const T& value = {}) {
        for (std::size_t i = 0; i < size; ++i)
            push_back(value);
    }

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] bool empty() const { return m_size == 0; }

    [[nodiscard]] const T& operator[](std::size_t index) const {
        assert(index < m_size);
        return (*m_chunks[index / kChunkSize])[index % kChunkSize];
    }

    /// The element for writing; its chunk is copied first if a copy of this array still shares it.
    [[nodiscard]] T& edit(std::size_t index) {
        assert(index < m_size);
        return own(index / kChunkSize)[index % kChunkSize];
    }

    void push_back(T value) {
        if (m_size % kChunkSize == 0) {
            m_chunks.push_back(std::make_shared<Chunk>());
            m_chunks.back()->reserve(kChunkSize);
            m_owned.push_back(true);
            m_ownsSome = true;
        }
        own(m_size / kChunkSize).push_back(std::move(value));
        ++m_size;
    }

    /// Keeps the first `size` elements.
    void truncate(std::size_t size) {
        if (size >= m_size)
            return;
        m_chunks.resize((size + kChunkSize - 1) / kChunkSize);
        m_owned.resize(m_chunks.size());
        m_size = size;
        if (size % kChunkSize != 0)
            own(size / kChunkSize).resize(size % kChunkSize);
    }

    void clear() { *this = PersistentArray(); }

private:
    using Chunk = std::vector<T>;

    Chunk& own(std::size_t chunk) {
        if (!m_owned[chunk]) {
            auto copy = std::make_shared<Chunk>();
            copy->reserve(kChunkSize);
            *copy = *m_chunks[chunk];
            m_chunks[chunk] = std::move(copy);
            m_owned[chunk] = true;
            m_ownsSome = true;
        }
        return *m_chunks[chunk];
    }

    std::vector<std::shared_ptr<Chunk>> m_chunks;
    mutable std::vector<bool> m_owned; ///< true: this object alone holds the chunk and may write into it
    mutable bool m_ownsSome = false;
    std::size_t m_size = 0;
};

} // namespace proveout
