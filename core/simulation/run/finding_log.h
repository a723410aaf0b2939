// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"
#include "core/nc/program/program.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

enum class FindingKind : std::uint8_t {
    rapidCuts,         ///< a rapid removed material; value: depth, mm
    depthBeyondFlutes, ///< more height removed at once than the flutes are long; value: depth, mm
    rapidUnchecked,    ///< a rapid from an unknown position ends in the stock; value: depth below its top, mm
    rapidAtUnknownHeight, ///< a rapid passes over the stock, and nobody knows how high; no value
    neckInStock,          ///< the neck of a cutter went through material above its head; value: height, mm
    overhangLost, ///< the z-map has lost what stays above a head; value: mm³, and the place of the highest
};

/// What the simulation found, block by block. Lines are asked from the program when the sentences are made,
/// because an edit moves lines without changing a block. Owned by one thread.
class FindingLog {
public:
    /// Blocks come in ascending order; a repeated kind of one block keeps the larger value. `unconfirmed`:
    /// the sizes of the tool are not confirmed, so that the finding is no fault.
    void add(std::size_t block, FindingKind kind, double value, bool unconfirmed = false);
    /// The same of a kind that names a place; one kind does.
    void add(std::size_t block, FindingKind kind, double value, bool unconfirmed, const Vec3& place);
    /// Whether there is anything about block `block`.
    [[nodiscard]] bool foundAt(std::size_t block) const;
    /// Forgets everything about blocks from `block` on.
    void truncate(std::size_t block);
    /// First what is known before any block, about the tools (each missing or unconfirmed one once); then
    /// what was found, at most one message of a kind per line (two where one is with an unconfirmed tool); no
    /// more in all than BoundedDiagnostics holds, and a last one tells how many more there are, as severe as
    /// the worst of them. `file` is left empty. Takes the same time however many were found, because every
    /// frame asks.
    [[nodiscard]] Diagnostics diagnostics(const Program& program, const ToolChoice& tools) const;

private:
    struct Finding {
        std::uint32_t block;
        FindingKind kind;
        bool unconfirmed; ///< the tool
        double value;
    };
    static constexpr std::size_t kKinds = 6;

    /// Values, place and tool for the text of a finding.
    [[nodiscard]] std::vector<Argument> argumentsOf(const Finding& finding, const Program& program,
                                                    const ToolChoice& tools) const;
    [[nodiscard]] std::size_t& countOf(const Finding& finding) {
        return m_counts[finding.unconfirmed ? 1 : 0][static_cast<std::size_t>(finding.kind)];
    }

    std::vector<Finding> m_findings;
    std::map<std::uint32_t, Vec3> m_places; ///< by block, of the kind that has them
    /// Of m_findings: with confirmed and with unconfirmed tools, by kind.
    std::array<std::array<std::size_t, kKinds>, 2> m_counts{};
};

} // namespace proveout
