// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/nc/program/program.h"

namespace proveout {

/// Receives the beginning of a program while the rest is still being read: at first soon, then at growing
/// intervals. Its last message says so and marks it unverified. Called on the thread of the interpreter.
using PublishBeginning = std::function<void(const std::shared_ptr<const Program>&)>;

/// Publishes an unfinished program. Keeps references to its arguments.
class Beginnings {
public:
    Beginnings(const PublishBeginning& publish, const std::string& file) : m_publish(publish), m_file(file) {}

    [[nodiscard]] bool isDue(const Program& soFar) const {
        return m_publish && soFar.motionCount() >= m_next && soFar.motionCount() <= kMost && soFar.settled();
    }
    /// `line`: of the main text, 1-based, which has been reached; `sourceBlocks`: those that have been read.
    void publish(const Program& soFar, std::uint32_t line, std::size_t sourceBlocks);

private:
    static constexpr std::size_t kFirst = 100'000;  ///< motions; shorter programs are complete almost at once
    static constexpr std::size_t kMost = 2'000'000; ///< a copy of more would use memory that the whole
                                                    ///< program needs

    const PublishBeginning& m_publish;
    const std::string& m_file;
    std::size_t m_next = kFirst;
};

} // namespace proveout
