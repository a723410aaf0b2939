// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON of messages from an editor, which may be damaged or hostile.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

namespace proveout::cli {

/// Codes of JSON-RPC and of the protocol.
enum class LspError : int {
    parseError = -32700,
    invalidRequest = -32600,
    methodNotFound = -32601,
    invalidParams = -32602,
    internalError = -32603,
    serverNotInitialized = -32002,
    requestCancelled = -32800,
};

/// A parameter is missing or has the wrong type; becomes LspError::invalidParams.
struct InvalidParameter : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Parses a message; nothing if it is not JSON, or nested more deeply or with more values than any message.
/// Halves of surrogate pairs and bytes that are not UTF-8 are replaced by U+FFFD.
[[nodiscard]] std::optional<nlohmann::json> parseLspMessage(std::string text);

/// A member of an object. Throws InvalidParameter if it is missing or has another type.
[[nodiscard]] const nlohmann::json& objectIn(const nlohmann::json& object, const char* key);
[[nodiscard]] const std::string& stringIn(const nlohmann::json& object, const char* key);
[[nodiscard]] std::size_t indexIn(const nlohmann::json& object, const char* key);

} // namespace proveout::cli
