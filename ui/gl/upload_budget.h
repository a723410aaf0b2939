// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>

namespace proveout {

/// The time limit for uploads within one frame; by default there is no limit. Value type.
class UploadBudget {
public:
    UploadBudget() = default;
    /// The time starts now.
    explicit UploadBudget(std::chrono::steady_clock::duration length)
        : m_end(std::chrono::steady_clock::now() + length) {}

    [[nodiscard]] bool spent() const { return m_end && std::chrono::steady_clock::now() >= *m_end; }

private:
    std::optional<std::chrono::steady_clock::time_point> m_end;
};

} // namespace proveout
