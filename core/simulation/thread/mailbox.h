// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace proveout {

/// Passes one value between threads; putting a value replaces one that was not taken yet.
template<class T>
class Mailbox {
public:
    void put(T value) {
        const std::scoped_lock lock(m_mutex);
        m_value = std::move(value);
    }
    [[nodiscard]] std::optional<T> take() {
        const std::scoped_lock lock(m_mutex);
        return std::exchange(m_value, std::nullopt);
    }

private:
    std::mutex m_mutex;
    std::optional<T> m_value;
};

} // namespace proveout
