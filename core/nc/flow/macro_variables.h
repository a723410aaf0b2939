// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/nc/program/program.h"
#include "core/nc/state/machine_state.h"
#include "core/nc/state/offset_registers.h"
#include "core/nc/text/parameters.h"

namespace proveout {

/// The system variables of custom macro B that milling programs read: modal codes (#4001 to #4130), positions
/// (#5001, #5021, #5041, #5061, #5081), offset registers (#2001, #10001 …), work offsets (#5201, #7001 …).
/// Those that depend on the machine or on the time of day are refused. Source: FANUC's operator's manuals.
/// Keeps references to its arguments.
class MacroVariables : public SystemValues {
public:
    MacroVariables(MachineState& state, Parameters& parameters, OffsetRegisters& registers,
                   const Dialect& dialect)
        : m_state(state), m_parameters(parameters), m_registers(registers), m_dialect(dialect) {}

    [[nodiscard]] std::optional<double> numbered(int number) const override;
    [[nodiscard]] const FindingRow* refusal(int number) const override;
    [[nodiscard]] bool writable(int number) const override;
    [[nodiscard]] std::optional<double> named(std::string_view name) const override;
    [[nodiscard]] double leastUnit() const override;

    enum class Writing : std::uint8_t {
        stored,  ///< by its number, like any other variable
        ignored, ///< a setting of the machine that does not affect the path
        offset,  ///< write(): it takes effect at once
        readOnly,
        alarm, ///< #3000: the program ends
        stop   ///< #3006: a program stop
    };
    [[nodiscard]] Writing writing(int number) const;
    /// The number under which a variable is stored.
    [[nodiscard]] int storedAs(int number) const;
    /// Writes an offset, in the unit of the program.
    void write(int number, double value, Program& program, std::uint32_t line);

private:
    [[nodiscard]] std::optional<double> ofRegister(int number) const;
    [[nodiscard]] std::optional<double> ofHaas(int number) const;

    MachineState& m_state;
    Parameters& m_parameters;
    OffsetRegisters& m_registers;
    const Dialect& m_dialect;
};

} // namespace proveout
