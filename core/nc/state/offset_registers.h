// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "core/nc/state/tool_offsets.h"
#include "core/nc/text/dialect.h"

namespace proveout {

/// The offset registers of Fanuc's dialect: H and D, geometry and wear, by number. A number that the program
/// never wrote has the geometry of the tool with its number and no wear. Lengths in mm. Keeps a reference to
/// the tools. Source: FANUC's operator's manuals, tool compensation memory C; Haas's manuals.
class OffsetRegisters {
public:
    static constexpr int kLargest = 999;

    using Entry = RegisterEntry;

    /// `diameters`: the radius registers hold diameters.
    OffsetRegisters(ToolOffsets& tools, bool diameters) : m_tools(tools), m_diameters(diameters) {}

    /// The contents of a register; nothing if unknown. Number 0 holds 0.
    [[nodiscard]] std::optional<double> value(Entry entry, int number) const;
    void set(Entry entry, int number, double value);

    /// The sum of geometry and wear.
    [[nodiscard]] std::optional<double> length(int number) const;
    [[nodiscard]] std::optional<double> radius(int number) const;

    /// Whether the contents come from given tools or from the program: otherwise they are assumed to be 0.
    [[nodiscard]] bool certain(Entry entry, int number) const;

    /// Whether the radius is that of a tool whose diameter is assumed.
    [[nodiscard]] bool assumedRadius(int number) const;

    /// What the program wrote, by number; by entry.
    using Contents = std::map<int, std::array<std::optional<double>, 4>>;
    [[nodiscard]] const Contents& contents() const { return m_written; }
    void restore(Contents contents) { m_written = std::move(contents); }

    struct Place {
        Entry entry;
        int number;
    };
    /// The register that a system variable names.
    [[nodiscard]] static std::optional<Place> place(const Dialect& dialect, int variable);

private:
    [[nodiscard]] const std::optional<double>* written(Entry entry, int number) const;

    ToolOffsets& m_tools;
    bool m_diameters;
    Contents m_written;
};

} // namespace proveout
