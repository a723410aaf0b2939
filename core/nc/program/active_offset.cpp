// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/program/active_offset.h"

#include <algorithm>
#include <fmt/format.h>
#include <variant>

#include "core/nc/codes/dialects.h"

namespace proveout {
namespace {

std::string codeOf(int system, const AdditionalOffsetCode& code) {
    constexpr int kStandard = 6; // G54 to G59
    constexpr int kLastStandard = 53 + kStandard;
    const int additional = system - kStandard;
    if (additional <= 0)
        return fmt::format("G{}", kLastStandard + additional);
    return fmt::format("{}{}", code.written, code.first + additional - 1);
}

} // namespace

ActiveOffset activeOffset(const Program& program, std::size_t blocks) {
    const std::size_t executed = std::min(blocks, program.blockCount());
    const std::size_t motion = executed == 0 ? 0 : program.blockMotions(executed - 1).last - 1;
    const std::vector<Event>& events = program.events();
    const auto after = std::ranges::upper_bound(events, motion, {}, &Event::beforeMotion);
    const auto before = std::make_reverse_iterator(after);
    const auto found = std::find_if(before, events.rend(), [](const Event& event) {
        return std::holds_alternative<WorkOffset>(event.data);
    });
    if (found == events.rend())
        return {};
    const auto& offset = std::get<WorkOffset>(found->data);
    return {codeOf(offset.system, dialect(program.dialect()).additionalCode), offset.offset};
}

} // namespace proveout
