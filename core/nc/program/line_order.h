// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace proveout {

/// How many motion blocks were executed before and after the first execution of each line of a program; the
/// subprograms that a line calls belong to its execution. Stores runs of consecutive lines: a program without
/// jumps is one run. Lines are numbered from 1. A value.
class LineOrder {
public:
    /// The state at an earlier moment. A value.
    struct Extent {
        std::size_t runs = 0;
        std::size_t depth = 0;
        std::uint32_t firstLine = 0; ///< of the run that the next line may continue; 0: none
        std::uint32_t lastLine = 0;
        std::uint32_t lastLineBlock = 0;
    };

    LineOrder() = default;
    /// The beginning of another order, as it was when it had that extent, after so many blocks.
    LineOrder(const LineOrder& other, const Extent& extent, std::size_t blocks);
    /// No subprogram may be open.
    [[nodiscard]] Extent extent() const;

    /// Before each line runs, in the order of execution: its number (0: a line of another file), the number
    /// of open calls, and the number of blocks so far.
    void begin(std::uint32_t line, std::size_t depth, std::size_t blocks);

    /// The blocks [first, last), in the order of their lines, among which the first execution of a line began
    /// or ended: first or last if it is before or after all of them. May exceed the blocks that there are.
    struct Range {
        std::size_t first = 0;
        std::size_t last = 0;
    };
    /// For a line that was not executed, both are the beginning of the next one that was; all blocks if there
    /// is none.
    [[nodiscard]] Range beginOf(std::uint32_t line) const;
    [[nodiscard]] Range endOf(std::uint32_t line) const;

    [[nodiscard]] std::size_t bytes() const { return m_runs.size() * kBytesPerRun; }

private:
    static constexpr std::uint32_t kUnknown = std::numeric_limits<std::uint32_t>::max();

    /// The first executions of consecutive lines, of which only the last one may have called.
    struct Run {
        std::uint32_t lastLine = 0;
        std::uint32_t firstBlock = 0;    ///< number of blocks before the first line
        std::uint32_t lastLineBlock = 0; ///< before the last line
        std::uint32_t end = kUnknown;    ///< after the last line
        std::uint32_t number = 0;        ///< in the order of execution
    };
    /// A run whose last line has not ended.
    struct Open {
        std::uint32_t firstLine = 0;
        std::size_t depth = 0;
    };

    /// By first line: lines may be executed in any order.
    using Runs = std::map<std::uint32_t, Run>;
    static constexpr std::size_t kBytesPerRun = 32 + sizeof(Runs::value_type); ///< with its links

    /// The first run that ends at a line or after it.
    [[nodiscard]] Runs::const_iterator runAt(std::uint32_t line) const;
    [[nodiscard]] bool isExecuted(std::uint32_t line) const;
    void endInnermost(std::size_t blocks);
    void add(std::uint32_t line, std::size_t depth, std::size_t blocks);

    Runs m_runs;
    std::vector<Open> m_open;
    std::size_t m_depth = 0; ///< of the line that began last
};

} // namespace proveout
