// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/outline_file.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/atomic_file.h"
#include "core/formats/stock_file_findings.h"

namespace proveout {

namespace {

constexpr std::uint64_t kSizeLimit = 64'000'000; ///< bytes; enough for some millions of points
constexpr std::string_view kSeparators = " \t,;\r";

Diagnostics about(const FindingRow& row, int line, const std::filesystem::path& file) {
    Diagnostics errors = failure(row, {}, file.string()).value();
    errors.front().where = {line, 1, 0};
    return errors;
}

/// The numbers of a line, at most four; nothing if it contains anything else.
std::optional<std::vector<double>> numbersOf(std::string_view line) {
    std::vector<double> numbers;
    while (true) {
        const auto first = line.find_first_not_of(kSeparators);
        if (first == std::string_view::npos || numbers.size() > 3)
            return numbers;
        line.remove_prefix(first);
        double value = 0;
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
        const auto length = static_cast<std::size_t>(end - line.data());
        const bool whole = length == line.size() || kSeparators.find(line[length]) != std::string_view::npos;
        if (error != std::errc{} || !whole || !std::isfinite(value))
            return std::nullopt;
        numbers.push_back(value);
        line.remove_prefix(length);
    }
}

} // namespace

Result<std::vector<OutlineLoop>> readOutline(const std::filesystem::path& file) {
    const auto text = readFile(file, kSizeLimit);
    if (!text)
        return tl::unexpected(text.error());
    std::vector<OutlineLoop> loops;
    OutlineLoop loop;
    int lineNumber = 0;
    const auto closes = [&] {
        const bool fine = loop.size() != 1;
        if (loop.size() > 1)
            loops.push_back(std::move(loop));
        loop = {};
        return fine;
    };
    std::string_view rest = *text;
    while (!rest.empty()) {
        const auto end = rest.find('\n');
        std::string_view line = rest.substr(0, end);
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
        ++lineNumber;
        const bool comment = line.find('#') != std::string_view::npos;
        line = line.substr(0, line.find('#'));
        const auto numbers = numbersOf(line);
        if (!numbers || numbers->size() == 1 || numbers->size() > 3)
            return tl::unexpected(about(stock_finding::kOutlineLine, lineNumber, file));
        if (!numbers->empty())
            loop.push_back({{(*numbers)[0], (*numbers)[1]}, numbers->size() == 3 ? (*numbers)[2] : 0});
        else if (!comment && !closes())
            return tl::unexpected(about(stock_finding::kOutlineLoop, lineNumber, file));
    }
    if (!closes())
        return tl::unexpected(about(stock_finding::kOutlineLoop, lineNumber, file));
    if (loops.empty())
        return failure(stock_finding::kOutlineEmpty, {}, file.string());
    return loops;
}

} // namespace proveout
