// SPDX-License-Identifier: GPL-3.0-or-later
// Where a run stops by itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/persistent_array.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/statistics.h"
#include "core/simulation/setup/tool_choice.h"
#include "core/simulation/thread/condition.h"

namespace proveout {

enum class BreakpointKind : std::uint8_t {
    line,         ///< before a block of a source line, or the first behind it where it moves nothing
    toolChange,   ///< before the first block behind one
    programStop,  ///< before the first block behind M0, M1, M60
    zBelow,       ///< before a block that goes below a height and comes from above it
    firstContact, ///< after the block of a tool run that is the first to remove material
    fault,        ///< after a block at which something was found
    condition,    ///< before a block at which a condition begins to hold
};

/// Value type.
struct Breakpoint {
    BreakpointKind kind = BreakpointKind::line;
    bool enabled = true;
    std::uint32_t line = 0; ///< of `line`, 1-based
    double z = 0;           ///< of `zBelow`, mm
    std::string condition;  ///< of `condition`

    friend bool operator==(const Breakpoint&, const Breakpoint&) = default;
};

/// What a kind is about beside its name.
enum class BreakpointValue : std::uint8_t { none, line, height, condition };

/// What is known when a block was executed.
struct ExecutedBlocks {
    const PersistentArray<BlockStatistics>& rows; ///< of all executed blocks
    bool somethingFound = false;                  ///< at the last of them
};

/// A breakpoint that is ready to be asked.
struct ArmedBreakpoint {
    Breakpoint breakpoint;
    Condition condition;
    std::optional<std::size_t> insteadOfLine; ///< the block behind a line that no block has
    int toolOfNone = 0;                       ///< of motions that name none (ToolChoice)
};

/// One row a kind, in their order. Texts are marked with PROVEOUT_TEXT.
struct BreakpointRow {
    BreakpointKind kind;
    const char* key;    ///< in settings
    const char* label;  ///< in lists
    const char* help;   ///< one sentence
    const char* reason; ///< why the run stopped; {} is the value, where there is one
    BreakpointValue value = BreakpointValue::none;
    /// Whether the run stops before block `block`; null: it is asked afterwards.
    bool (*before)(const ArmedBreakpoint&, const Program&, std::size_t block) = nullptr;
    /// Whether it stops after `block`, which was executed; null: it was asked before.
    bool (*after)(const Program&, std::size_t block, const ExecutedBlocks&) = nullptr;
};
[[nodiscard]] std::span<const BreakpointRow> breakpointRows();
[[nodiscard]] const BreakpointRow& rowOf(BreakpointKind kind);
/// "Z -20", "120", "Z < -20 && T == 3"; empty for a kind without a value.
[[nodiscard]] Argument valueText(const Breakpoint& breakpoint);

/// A run was stopped. Immutable once published.
struct BreakpointHit {
    Breakpoint breakpoint;
    std::size_t block = 0; ///< blocks executed so far
};

/// The breakpoints of a run; those that are off, and conditions that cannot be read, never stop it. Edges
/// count: a run goes on from a block where a condition holds, until it holds anew. One thread.
class Breakpoints {
public:
    /// More than this many are ignored: each is asked at each block.
    static constexpr std::size_t kMost = 1000;

    void set(const std::vector<Breakpoint>& breakpoints, const Program& program, const ToolChoice& tools);
    /// The program is another one.
    void follow(const Program& program, const ToolChoice& tools);
    [[nodiscard]] bool empty() const { return m_armed.empty(); }
    /// The first that stops the run before block `block` is executed; null: none.
    [[nodiscard]] const Breakpoint* before(const Program& program, std::size_t block) const;
    /// The first that stops it after `block` was.
    [[nodiscard]] const Breakpoint* after(const Program& program, std::size_t block,
                                          const ExecutedBlocks& executed) const;

private:
    std::vector<ArmedBreakpoint> m_armed;
};

} // namespace proveout
