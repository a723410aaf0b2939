// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/digest.h"

#include <array>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <openssl/evp.h>
#include <vector>

namespace proveout::cli {

std::optional<std::string> sha256(const std::filesystem::path& file) {
    constexpr std::size_t kPart = 1 << 16;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        return std::nullopt;
    std::ifstream in(file, std::ios::binary);
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> digest(EVP_MD_CTX_new(), EVP_MD_CTX_free);
    if (!in || digest == nullptr || EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr) != 1)
        return std::nullopt;
    std::vector<char> part(kPart);
    while (in) {
        in.read(part.data(), static_cast<std::streamsize>(part.size()));
        if (EVP_DigestUpdate(digest.get(), part.data(), static_cast<std::size_t>(in.gcount())) != 1)
            return std::nullopt;
    }
    std::array<unsigned char, EVP_MAX_MD_SIZE> value{};
    unsigned length = 0;
    if (!in.eof() || EVP_DigestFinal_ex(digest.get(), value.data(), &length) != 1)
        return std::nullopt;
    std::string text;
    for (unsigned k = 0; k < length; ++k)
        text += fmt::format("{:02x}", value[k]);
    return text;
}

} // namespace proveout::cli
