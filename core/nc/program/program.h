// SPDX-License-Identifier: GPL-3.0-or-later
// The meaning of an NC text: its motions and events in the order of execution, and its messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"
#include "core/nc/codes/ignored_codes.h"
#include "core/nc/program/control_state.h"
#include "core/nc/program/line_order.h"
#include "core/nc/program/line_values.h"
#include "core/nc/program/motion.h"
#include "core/nc/text/dialect.h"

namespace proveout {

enum class Coolant : std::uint8_t { mist, flood };
enum class StopKind : std::uint8_t { program, optional, palletChange };

struct ToolChange {
    int tool = 0;
    bool numberOnly = false; ///< M61: the control is told which tool is in the spindle
};
struct ToolLengthOffset {
    Vec3 offset{0};
};
struct Dwell {
    double seconds = 0;
};
struct CoolantSwitch {
    Coolant coolant = Coolant::flood;
    bool on = false;
};
struct ProgramStop {
    StopKind kind = StopKind::program;
};
struct ProgramEnd {};
struct UnitsChange {
    bool inch = false;
};
/// A work offset became active or was changed; `system` is 1 for G54.
struct WorkOffset {
    int system = 1;
    Vec3 offset{0};
};

using EventData = std::variant<ToolChange, ToolLengthOffset, Dwell, CoolantSwitch, ProgramStop, ProgramEnd,
                               UnitsChange, WorkOffset>;

/// Something that happens between motions.
struct Event {
    std::uint32_t beforeMotion = 0; ///< index of the first motion after it
    std::uint32_t line = 0;         ///< source line, 1-based
    EventData data;
};

/// The result of an interpretation. Built by the interpreter through `append…`, immutable afterwards;
/// published as shared_ptr<const Program> and read from any thread. Motions are stored packed and handed out
/// by value.
class Program {
public:
    [[nodiscard]] std::size_t motionCount() const { return m_motions.size(); }
    [[nodiscard]] Motion motion(std::size_t index) const;
    [[nodiscard]] const Vec3& endOf(std::size_t index) const { return m_motions[index].end; }
    /// The programmed end of motion `index`, which differs from its end under cutter compensation.
    [[nodiscard]] Vec3 programmedEnd(std::size_t index) const;

    static constexpr std::size_t kBytesPerMotion = 48;       ///< straight; an arc needs more
    static constexpr std::size_t kBytesPerCompensation = 16; ///< in addition, under cutter compensation
    /// Bytes of all motions, blocks and events; about as much again is allocated while it grows.
    [[nodiscard]] std::size_t bytes() const;

    /// Motion blocks, in the order of execution: the unit of stepping, of the decimation period and of
    /// `--until N`. One block may program several motions.
    [[nodiscard]] std::size_t blockCount() const { return m_blocks.size(); }
    /// The motions [first, last) of block `index`.
    struct MotionRange {
        std::size_t first;
        std::size_t last;
    };
    [[nodiscard]] MotionRange blockMotions(std::size_t index) const;
    [[nodiscard]] std::uint32_t blockLine(std::size_t index) const;
    /// How many motion blocks have been executed before and after source line `line` at its first execution,
    /// which includes the subprograms that it calls. If it is never executed, both are those before the next
    /// line that is, or blockCount().
    [[nodiscard]] std::size_t blocksBeforeLine(std::uint32_t line) const;
    [[nodiscard]] std::size_t blocksAfterLine(std::uint32_t line) const;

    /// Consecutive motions [first, last) with one tool in the spindle.
    struct ToolRun {
        int tool = 0; ///< 0: none
        std::size_t first = 0;
        std::size_t last = 0;
    };
    /// All motions, in order; neighbours have different tools. Reads only a few of the motions.
    [[nodiscard]] std::vector<ToolRun> toolRuns() const;

    [[nodiscard]] const std::vector<Event>& events() const { return m_events; }
    [[nodiscard]] const Diagnostics& diagnostics() const { return m_diagnostics; }
    /// Index of the first motion after diagnostic `index` was reported.
    [[nodiscard]] std::size_t motionAfterDiagnostic(std::size_t index) const {
        return m_diagnosticMotions[index];
    }
    /// Whether any diagnostic marks the rest of the program as unverified.
    [[nodiscard]] bool unverified() const { return m_unverified; }
    /// Source blocks with at least one word (comments alone do not count).
    [[nodiscard]] std::size_t sourceBlockCount() const { return m_sourceBlocks; }
    /// Whether the result depends on the sizes of the control's tools.
    [[nodiscard]] bool asksForTools() const { return m_asksForTools; }
    /// Whether it probes, so that the result depends on stock and cutters.
    [[nodiscard]] bool asksForStock() const { return m_asksForStock; }
    /// Whether lines may have been executed more than once: a loop, or a subprogram.
    [[nodiscard]] bool runsAgain() const { return m_runsAgain; }
    /// Of the watched line; null if there is none.
    [[nodiscard]] const std::shared_ptr<const LineValues>& lineValues() const { return m_lineValues; }
    /// The state of the control where the interpretation ended.
    [[nodiscard]] const ControlState& controlState() const { return m_controlState; }
    /// The dialect in which it was read.
    [[nodiscard]] DialectId dialect() const { return m_dialect; }
    /// What kind of text it is if no control of dialects() can read it, marked with PROVEOUT_TEXT; then the
    /// program has one message and nothing else. Null: a program.
    [[nodiscard]] const char* foreignKind() const { return m_foreignKind; }
    /// M codes of the program that were ignored.
    [[nodiscard]] const IgnoredCodes& ignoredCodes() const { return m_ignoredCodes; }
    [[nodiscard]] const Box3& bounds() const { return m_bounds; } ///< of all known motions
    /// Of the known motions at feed that do not probe: where the program intends to cut.
    [[nodiscard]] const Box3& cuttingBounds() const { return m_cuttingBounds; }

    /// Index of the first block that moves differently (path, tool, or a different number of motions); the
    /// smaller block count if one program is the beginning of the other.
    [[nodiscard]] std::size_t firstDifference(const Program& other) const;

    /// The size of a program while it is built. A value.
    struct Extent {
        std::size_t motions = 0;
        std::size_t arcs = 0;
        std::size_t states = 0;
        std::size_t blocks = 0;
        std::size_t jumps = 0;
        std::size_t compensations = 0;
        std::size_t events = 0;
        std::size_t diagnostics = 0;
        Box3 bounds;
        Box3 cuttingBounds;
        std::uint32_t pendingLine = 0;
        bool blockPending = false;
        LineOrder::Extent lines;
        std::size_t settled = 0; ///< number of motions included in the bounds
    };

    Program() = default;
    /// The beginning of another program, as it was when it had that extent.
    Program(const Program& other, const Extent& extent);

    // For the interpreter, while the program is built.
    void expect(std::size_t blocks); ///< expected number of blocks; untouched memory is not resident
    [[nodiscard]] Extent extent() const;
    /// Whether the ends of all motions are final.
    [[nodiscard]] bool settled() const { return m_settled == m_motions.size(); }
    /// Before each line is executed; see LineOrder.
    void beginLine(std::uint32_t line, std::size_t openCalls) {
        m_lines.begin(line, openCalls, m_blocks.size());
    }
    void beginBlock(std::uint32_t line); ///< motions appended from here on belong to one block
    void append(const Motion& motion);
    /// A motion under cutter compensation. Its end may be moved until `settle`.
    void appendCompensated(const Motion& motion, const Vec3& programmedEnd);
    /// Whether the end of a motion is final.
    [[nodiscard]] bool isSettled(std::size_t motion) const { return motion < m_settled; }
    /// Moves the ends of the motions from `first` on, in the axes of a plane; `sweep` is that of the first,
    /// if it is an arc. None of them is settled, and only the first moves in the plane.
    void moveEnds(std::size_t first, Plane plane, const Vec2& end, double sweep);
    /// From now on the present motions are final.
    void settle();
    /// Removes the motions, blocks and events after an earlier extent and frees their memory. The messages
    /// stay.
    void cutBack(const Extent& extent);
    /// Moves the events from `first` on to after the present motions, none of which is settled.
    void delayEvents(std::size_t first);
    void append(EventData data, std::uint32_t line);
    void append(Diagnostic diagnostic);
    void setSourceBlockCount(std::size_t count) { m_sourceBlocks = count; }
    void setAsksForTools(bool asks) { m_asksForTools = asks; }
    void setAsksForStock(bool asks) { m_asksForStock = asks; }
    void setRunsAgain(bool again) { m_runsAgain = again; }
    void setLineValues(std::shared_ptr<const LineValues> values) { m_lineValues = std::move(values); }
    void setControlState(ControlState state) { m_controlState = std::move(state); }
    void setDialect(DialectId dialect) { m_dialect = dialect; }
    void setForeignKind(const char* kind) { m_foreignKind = kind; }
    void setIgnoredCodes(IgnoredCodes codes) { m_ignoredCodes = std::move(codes); }

private:
    struct PackedMotion {
        Vec3 end;
        float feedMmPerMin;
        std::uint32_t line;
        std::uint32_t arc;   ///< index into m_arcs, kNoArc for straight motions
        std::uint32_t state; ///< index into m_states
        std::uint8_t kind;
        std::uint8_t startKnown;
        std::uint8_t endKnown;
        std::uint8_t flags;
    };
    struct PackedArc {
        Vec3 centre;
        double sweep;
        Plane plane;
    };
    /// Values that change rarely, shared by many motions.
    struct SpindleState {
        int tool;
        double spindleRpm;
        double orderedRpm;
        bool operator==(const SpindleState&) const = default;
    };
    struct PackedBlock {
        std::uint32_t firstMotion;
        std::uint32_t line;
    };
    /// A motion that does not begin where the one before it ended.
    struct Jump {
        std::uint32_t motion;
        Vec3 start;
    };

    /// From the programmed end to the end of a motion; float precision is enough for display.
    struct Compensation {
        std::uint32_t motion;
        glm::vec3 offset;
    };

    [[nodiscard]] std::size_t firstBlockFrom(std::uint32_t line, const LineOrder::Range& among) const;
    void store(const Motion& motion);
    void addToBounds(const Motion& motion);
    [[nodiscard]] Vec3 startOf(std::size_t index) const;
    [[nodiscard]] bool sameBlock(std::size_t index, const Program& other) const;
    [[nodiscard]] bool samePath(std::size_t index, const Program& other, std::size_t otherIndex) const;

    std::vector<PackedMotion> m_motions;
    std::vector<PackedArc> m_arcs;
    std::vector<SpindleState> m_states;
    std::vector<PackedBlock> m_blocks;
    std::vector<Jump> m_jumps;
    std::vector<Compensation> m_compensations; ///< by motion
    std::vector<Event> m_events;
    Diagnostics m_diagnostics;
    std::vector<std::uint32_t> m_diagnosticMotions;
    std::size_t m_sourceBlocks = 0;
    std::size_t m_settled = 0; ///< motions before it are final and within m_bounds
    Box3 m_bounds;
    Box3 m_cuttingBounds;
    std::uint32_t m_pendingLine = 0;
    bool m_blockPending = false;
    LineOrder m_lines;
    bool m_unverified = false;
    bool m_asksForTools = false;
    bool m_asksForStock = false;
    bool m_runsAgain = false;
    std::shared_ptr<const LineValues> m_lineValues;
    ControlState m_controlState;
    DialectId m_dialect = DialectId::linuxcnc;
    const char* m_foreignKind = nullptr;
    IgnoredCodes m_ignoredCodes;
};

} // namespace proveout
