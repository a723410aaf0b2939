// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"
#include "core/nc/program/program.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

enum class FindingKind : std::uint8_t {
    rapidCuts, ///< a rapid removed material; value: depth, mm, and the place of the tip over the middle of it
    depthBeyondFlutes, ///< more height removed at once than the length of the flutes; value: depth, mm
    rapidUnchecked,    ///< a rapid from an unknown position ends in the stock; value: depth below its top, mm
    rapidAtUnknownHeight, ///< a rapid passes over the stock at an unknown height; no value
    neckInStock,          ///< the neck of a cutter went through material above its head; value: height, mm
    overhangLost, ///< the z-map has lost material that remains above a head; value: mm³, and the place of the
                  ///< highest
    holderCollision, ///< the holder is in the stock; value: depth, mm, and the place of the deepest
    shankCollision,  ///< the same of the shank
    corePlunges,     ///< a tool that is not centre-cutting goes straight down into material; value: depth, mm
};

/// All findings of one kind with one tool.
struct FindingGroup {
    Diagnostic worst{}; ///< at the line of the first block
    std::size_t firstBlock = 0;
    std::size_t lastBlock = 0;
    std::size_t worstBlock = 0;
    std::size_t count = 0; ///< of blocks
    int tool = 0;
    double value = 0;               ///< the largest
    const char* unit = "";          ///< empty: it has no value
    std::optional<Vec3> place = {}; ///< of the worst, for kinds that have one
};

/// The findings of the simulation, block by block. Line numbers are read from the program when the sentences
/// are made, because an edit moves lines without changing a block. Owned by one thread.
class FindingLog {
public:
    /// Add blocks in ascending order; if a block has a kind repeatedly, the larger value is kept.
    /// `unconfirmed`: the sizes of the tool are not confirmed, so that the finding is not a fault.
    void add(std::size_t block, FindingKind kind, double value, bool unconfirmed = false);
    /// The same for a kind that has a place: that of the value that is kept.
    void add(std::size_t block, FindingKind kind, double value, bool unconfirmed, const Vec3& place);
    /// Whether there is a finding for block `block`.
    [[nodiscard]] bool foundAt(std::size_t block) const;
    /// Discards everything about blocks from `block` on.
    void truncate(std::size_t block);
    /// First the findings known before any block, about the tools (each missing or unconfirmed one once);
    /// then those of the blocks, at most one message of a kind per line (two if one is with an unconfirmed
    /// tool). No more than BoundedDiagnostics holds; a last message gives the number of further ones and is
    /// as severe as the worst of them. `file` is empty. Takes the same time for any number of findings,
    /// because every frame calls it.
    [[nodiscard]] Diagnostics diagnostics(const Program& program, const ToolChoice& tools) const;
    /// Those of the blocks, in the order of their first ones.
    [[nodiscard]] std::vector<FindingGroup> groups(const Program& program, const ToolChoice& tools) const;

private:
    struct Finding {
        std::uint32_t block;
        FindingKind kind;
        bool unconfirmed; ///< the tool
        double value;
    };
    struct Place {
        std::uint32_t block;
        FindingKind kind;
        Vec3 at;
    };
    static constexpr std::size_t kKinds = 9;

    /// False if a larger value is kept.
    bool keepLarger(std::uint32_t block, FindingKind kind, double value, bool unconfirmed);
    /// Its index in m_places; the number of places if it has none.
    [[nodiscard]] std::size_t placeOf(std::uint32_t block, FindingKind kind) const;
    /// Values, place and tool for the text of a finding.
    [[nodiscard]] std::vector<Argument> argumentsOf(const Finding& finding, const Program& program,
                                                    const ToolChoice& tools) const;
    [[nodiscard]] std::size_t& countOf(const Finding& finding) {
        return m_counts[finding.unconfirmed ? 1 : 0][static_cast<std::size_t>(finding.kind)];
    }

    std::vector<Finding> m_findings;
    std::vector<Place> m_places; ///< of kinds that have places; blocks ascending
    /// Counts of m_findings by kind: with confirmed and with unconfirmed tools.
    std::array<std::array<std::size_t, kKinds>, 2> m_counts{};
};

} // namespace proveout
