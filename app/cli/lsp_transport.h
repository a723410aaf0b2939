// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of the Language Server Protocol: a header with the length of the message, then the message.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace proveout::cli {

constexpr std::size_t kLargestLspMessage = 256'000'000; ///< bytes

/// Takes messages out of a stream of bytes. Whatever the bytes are, it continues with the next valid header,
/// and it keeps at most one message. One thread.
class LspInput {
public:
    /// Reads up to `size` bytes, waiting for the first one; 0: the end.
    using Read = std::function<std::size_t(char* bytes, std::size_t size)>;
    /// Receives a sentence about bytes that are skipped.
    using Complain = std::function<void(const std::string& sentence)>;

    LspInput(Read read, Complain complain, std::size_t largest = kLargestLspMessage)
        : m_read(std::move(read)), m_complain(std::move(complain)), m_largest(largest) {}

    /// The next message; nothing at the end of the stream.
    [[nodiscard]] std::optional<std::string> next();

private:
    /// What the lines up to an empty one state.
    struct Header {
        std::optional<std::size_t> length;
        std::size_t end = 0; ///< index in m_bytes of the message
    };

    bool fill();
    [[nodiscard]] bool searchHeader();
    [[nodiscard]] std::optional<Header> readHeader();
    [[nodiscard]] bool readLine(std::size_t& at, std::string_view& line);
    bool lose(const std::string& sentence);

    Read m_read;
    Complain m_complain;
    std::size_t m_largest;
    std::string m_bytes; ///< read, and not yet taken
    bool m_lost = false; ///< a header has to be searched for
    bool m_ended = false;
};

/// Writes messages to stdout, whole and one after the other. Any thread.
class LspOutput {
public:
    void send(const nlohmann::json& message);
    /// A notification.
    void notify(const char* method, nlohmann::json parameters);
    /// Whether stdout cannot be written any more.
    [[nodiscard]] bool failed();

private:
    std::mutex m_mutex;
    bool m_failed = false;
};

} // namespace proveout::cli
