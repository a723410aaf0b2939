// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/machine.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <string>
#include <utility>

#include "core/base/figures_argument.h"
#include "core/simulation/setup/setup_findings.h"

namespace proveout {

namespace {

Result<void> setField(Machine& machine, std::string_view key, std::string_view text) {
    std::string keys;
    Result<void> result;
    bool known = false;
    describe(machine, [&](double& value, const Field& field) {
        keys += (keys.empty() ? "" : ", ") + std::string(field.key);
        if (key != field.key)
            return;
        known = true;
        double number = 0;
        const char* end = text.data() + text.size();
        const auto [read, error] = std::from_chars(text.data(), end, number);
        if (error == std::errc() && read == end && isInRange(field, number))
            value = number;
        else
            result = failure(setup_finding::kMachineValue,
                             {std::string(key), figures("{}", field.minimum), figures("{}", field.maximum)});
    });
    if (!known)
        return failure(setup_finding::kMachineKey, {std::string(key), keys});
    return result;
}

} // namespace

Result<Machine> parseMachine(std::string_view text, Machine machine) {
    while (!text.empty()) {
        const std::string_view item = text.substr(0, text.find(','));
        text.remove_prefix(std::min(text.size(), item.size() + 1));
        const std::size_t sign = item.find('=');
        const std::string_view value =
            sign == std::string_view::npos ? std::string_view() : item.substr(sign + 1);
        if (auto set = setField(machine, item.substr(0, sign), value); !set)
            return tl::unexpected(std::move(set.error()));
    }
    return machine;
}

} // namespace proveout
