// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/digest.h"

#include <array>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>
#include <nettle/sha2.h>
#include <vector>

namespace proveout::cli {

std::optional<std::string> sha256(const std::filesystem::path& file) {
    constexpr std::size_t kPart = 1 << 16;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        return std::nullopt;
    std::ifstream in(file, std::ios::binary);
    if (!in)
        return std::nullopt;
    sha256_ctx digest;
    sha256_init(&digest);
    std::vector<char> part(kPart);
    while (in) {
        in.read(part.data(), static_cast<std::streamsize>(part.size()));
        sha256_update(&digest, static_cast<std::size_t>(in.gcount()),
                      reinterpret_cast<const std::uint8_t*>(part.data()));
    }
    if (!in.eof())
        return std::nullopt;
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> value{};
    sha256_digest(&digest, value.size(), value.data());
    std::string text;
    for (const std::uint8_t byte : value)
        text += fmt::format("{:02x}", byte);
    return text;
}

} // namespace proveout::cli
