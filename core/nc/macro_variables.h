// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/nc/machine_state.h"
#include "core/nc/parameters.h"

namespace proveout {

/// The system variables of custom macro B that milling programs read: modal codes (#4001 to #4130), positions
/// (#5001, #5021, #5041, #5061, #5081), offsets. Those that depend on the machine or on the time of day are
/// refused. Source: FANUC's operator's manuals. Keeps references to its arguments.
class MacroVariables : public SystemValues {
public:
    MacroVariables(const MachineState& state, const Dialect& dialect) : m_state(state), m_dialect(dialect) {}

    [[nodiscard]] std::optional<double> numbered(int number) const override;
    [[nodiscard]] const Message* refusal(int number) const override;
    [[nodiscard]] bool writable(int number) const override;
    [[nodiscard]] std::optional<double> named(std::string_view name) const override;
    [[nodiscard]] double leastUnit() const override;

    enum class Writing : std::uint8_t {
        stored,  ///< by its number, as any other
        ignored, ///< a setting of the machine without a path of its own
        readOnly,
        alarm, ///< #3000: the program ends
        stop   ///< #3006: a program stop
    };
    [[nodiscard]] static Writing writing(int number);

private:
    const MachineState& m_state;
    const Dialect& m_dialect;
};

} // namespace proveout
