// SPDX-License-Identifier: GPL-3.0-or-later
// Breakpoints, at which a run stops by itself.
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
    line,         ///< before a block of a source line, or the next one after it if the line moves nothing
    toolChange,   ///< before the first block after one
    programStop,  ///< before the first block after M0, M1, M60
    zBelow,       ///< before a block that moves from above a height to below it
    firstContact, ///< after the block of a tool run that is the first to remove material
    fault,        ///< after a block with a finding
    condition,    ///< before a block at which a condition becomes true
};

/// Value type.
struct Breakpoint {
    BreakpointKind kind = BreakpointKind::line;
    bool enabled = true;
    std::uint32_t line = 0; ///< for `line`, 1-based
    double z = 0;           ///< for `zBelow`, mm
    std::string condition;  ///< for `condition`

    friend bool operator==(const Breakpoint&, const Breakpoint&) = default;
};

/// The type of the value of a kind.
enum class BreakpointValue : std::uint8_t { none, line, height, condition };

/// What is known once a block was executed.
struct ExecutedBlocks {
    const PersistentArray<BlockStatistics>& rows; ///< of all executed blocks
    bool somethingFound = false;                  ///< at the last of them
};

/// A breakpoint prepared for evaluation.
struct ArmedBreakpoint {
    Breakpoint breakpoint;
    Condition condition;
    std::optional<std::size_t> insteadOfLine; ///< the block after a line that has no block
    int toolOfNone = 0;                       ///< for motions that do not name a tool (ToolChoice)
};

/// One row per kind, in order. Texts are marked with PROVEOUT_TEXT.
struct BreakpointRow {
    BreakpointKind kind;
    const char* key;    ///< in settings
    const char* label;  ///< in lists
    const char* help;   ///< one sentence
    const char* reason; ///< why the run stopped; {} is the value, if there is one
    BreakpointValue value = BreakpointValue::none;
    /// Whether the run stops before block `block`; null: the kind is checked afterwards.
    bool (*before)(const ArmedBreakpoint&, const Program&, std::size_t block) = nullptr;
    /// Whether it stops after `block`, which was executed; null: the kind was checked before.
    bool (*after)(const Program&, std::size_t block, const ExecutedBlocks&) = nullptr;
};
[[nodiscard]] std::span<const BreakpointRow> breakpointRows();
[[nodiscard]] const BreakpointRow& rowOf(BreakpointKind kind);
/// "Z -20", "120", "Z < -20 && T == 3"; empty for a kind without a value.
[[nodiscard]] Argument valueText(const Breakpoint& breakpoint);

/// Describes why a run stopped. Immutable once published.
struct BreakpointHit {
    Breakpoint breakpoint;
    std::size_t block = 0; ///< number of blocks executed
};

/// The breakpoints of a run; those that are disabled, and conditions that cannot be read, never stop it. Only
/// a change to true counts: a run continues from a block where a condition holds until the condition becomes
/// true again. One thread.
class Breakpoints {
public:
    /// More breakpoints than this are ignored: each is checked at each block.
    static constexpr std::size_t kMost = 1000;

    void set(const std::vector<Breakpoint>& breakpoints, const Program& program, const ToolChoice& tools);
    /// Call it when the program has changed.
    void follow(const Program& program, const ToolChoice& tools);
    [[nodiscard]] bool empty() const { return m_armed.empty(); }
    /// The first that stops the run before block `block` is executed; null: none.
    [[nodiscard]] const Breakpoint* before(const Program& program, std::size_t block) const;
    /// The first that stops it after `block` was executed.
    [[nodiscard]] const Breakpoint* after(const Program& program, std::size_t block,
                                          const ExecutedBlocks& executed) const;

private:
    std::vector<ArmedBreakpoint> m_armed;
};

} // namespace proveout
