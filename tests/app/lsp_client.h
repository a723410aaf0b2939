// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <sys/types.h>

namespace proveout {

/// Runs the real language server over pipes, as an editor does. A read that takes too long ends the server,
/// so that the test fails and does not wait forever.
class LspClient {
public:
    using Json = nlohmann::json;

    /// `arguments`: after the command.
    explicit LspClient(const std::string& arguments = {});
    ~LspClient();
    LspClient(const LspClient&) = delete;
    LspClient& operator=(const LspClient&) = delete;

    void sendBytes(const std::string& bytes);
    void sendText(const std::string& json);
    int request(const std::string& method, const Json& parameters);
    void notify(const std::string& method, const Json& parameters);
    /// The next message; null at the end.
    [[nodiscard]] Json next();
    /// The next message that fits; others are dropped. Null at the end.
    [[nodiscard]] Json until(const std::function<bool(const Json&)>& fits);
    /// The answer to a request.
    [[nodiscard]] Json answer(int id);
    [[nodiscard]] Json ask(const std::string& method, const Json& parameters) {
        return answer(request(method, parameters));
    }

    /// Requests `initialize`; returns the capabilities of the server.
    Json initialize(const Json& capabilities = Json::object());
    void open(const std::string& uri, const std::string& text, int version = 1);
    void change(const std::string& uri, int version, const Json& changes);
    /// The diagnostics of a version.
    [[nodiscard]] Json diagnostics(int version);
    /// Closes the input; the exit code, or -1 for a signal.
    int finish();

private:
    pid_t m_pid = -1;
    std::FILE* m_to = nullptr;
    std::FILE* m_from = nullptr;
    int m_lastId = 0;
};

} // namespace proveout
