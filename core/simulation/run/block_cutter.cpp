// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/block_cutter.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "core/cutting/cut/core_contact.h"
#include "core/cutting/cut/overhang.h"
#include "core/simulation/run/statistics.h"
#include "core/simulation/run/tool_assemblies.h"

namespace proveout {

namespace {

void judge(const Overhang& overhang, bool unconfirmed, std::size_t block, FindingLog& findings) {
    if (overhang.neckDepth > kNothingRemoved)
        findings.add(block, FindingKind::neckInStock, overhang.neckDepth, unconfirmed);
    if (overhang.height > kNothingRemoved)
        findings.add(block, FindingKind::overhangLost, overhang.volumeMm3, unconfirmed, overhang.place);
}

void judge(const AssemblyContact& contact, bool unconfirmed, std::size_t block, FindingLog& findings) {
    if (contact.shank.depth > 0)
        findings.add(block, FindingKind::shankCollision, contact.shank.depth, unconfirmed,
                     contact.shank.place);
    if (contact.holder.depth > 0)
        findings.add(block, FindingKind::holderCollision, contact.holder.depth, unconfirmed,
                     contact.holder.place);
}

/// Of a motion that plungesWithCore(), on the map before it is cut.
void judgeCore(const ZMap& zmap, const Cutter& cutter, const Motion& motion, bool unconfirmed,
               std::size_t block, FindingLog& findings) {
    if (const PartContact core = coreContact(zmap, cutter, motion); core.depth > 0)
        findings.add(block, FindingKind::corePlunges, core.depth, unconfirmed);
}

/// Whether the tool may be over the stock in plan: an axis of unknown position may be anywhere.
bool mayMeetInPlan(const StockBox& stock, const Motion& motion, double radius) {
    const auto within = [&](int axis, AxisBits bit, double from, double length) {
        return (motion.endKnown & bit) == 0 ||
               (motion.end[axis] > from - radius && motion.end[axis] < from + length + radius);
    };
    return within(0, kAxisX, stock.corner.x, stock.width) && within(1, kAxisY, stock.corner.y, stock.depth);
}

/// Whether the tool, at rest at the end of the motion, would be in the remaining stock.
bool isInStock(const ZMap& zmap, const Cutter& cutter, const ToolAssembly& assembly, const Motion& motion) {
    ZMap trial(zmap.snapshot());
    Motion stationary = motion;
    stationary.start = motion.end;
    stationary.startKnown = kAllAxes;
    return assembly.contact(zmap, stationary, {})->any() ||
           cut(trial, cutter, stationary).maxDepth > kNothingRemoved;
}

/// A rapid to, at or from the machine's reference position, which is above everything, that stays clear of
/// the part: straight up or down, or beginning above the stock. The end of a move down is checked elsewhere.
bool clearByReference(const StockBox& stock, const Motion& motion) {
    if (motion.startAtReference && motion.endAtReference)
        return true;
    constexpr std::uint8_t kPlan = kAxisX | kAxisY;
    const bool upright = (motion.startKnown & motion.endKnown & kPlan) == kPlan &&
                         motion.start.x == motion.end.x && motion.start.y == motion.end.y;
    const bool above = (motion.startKnown & kAxisZ) != 0 && motion.start.z >= stock.topZ();
    return motion.endAtReference && (upright || above);
}

/// A rapid that moves in plan at an unknown height may pass through the stock. The box of its ends is used in
/// place of its path; an axis that it moves to an unknown position may pass over anything.
bool mayCrossAtUnknownHeight(const StockBox& stock, const Motion& motion, double radius) {
    if ((motion.endKnown & kAxisZ) != 0 || (motion.startKnown & (kAxisX | kAxisY)) != (kAxisX | kAxisY))
        return false;
    const auto meets = [&](int axis, AxisBits bit, double from, double length) {
        if ((motion.endKnown & bit) == 0)
            return true;
        const auto [lo, hi] = std::minmax(motion.start[axis], motion.end[axis]);
        return hi > from - radius && lo < from + length + radius;
    };
    return meets(0, kAxisX, stock.corner.x, stock.width) && meets(1, kAxisY, stock.corner.y, stock.depth);
}

/// The path of a rapid from an unknown position is unknown too, so it cuts nothing. Most programs begin this
/// way, with a move to a safe height; a rapid that ends in the stock, or continues over it at an unknown
/// height, must not count as checked.
void judgeUnknownRapid(const ZMap& zmap, const Cutter& cutter, const ToolAssembly& assembly,
                       const Motion& motion, std::size_t block, FindingLog& findings) {
    if (clearByReference(zmap.stock(), motion))
        return;
    const double radius = std::max(cutter.radius(), assembly.radius());
    if (mayCrossAtUnknownHeight(zmap.stock(), motion, radius)) {
        findings.add(block, FindingKind::rapidAtUnknownHeight, 0);
        return;
    }
    const double below = zmap.stock().topZ() - motion.end.z;
    if ((motion.endKnown & kAxisZ) == 0 || below <= kNothingRemoved ||
        !mayMeetInPlan(zmap.stock(), motion, radius))
        return;
    if (motion.endKnown != kAllAxes || isInStock(zmap, cutter, assembly, motion))
        findings.add(block, FindingKind::rapidUnchecked, below);
}

/// The point of a straight path that is nearest to the middle of what was removed there, in plan; the lower
/// end of a vertical one.
Vec3 overRemoved(const Grid& grid, const IndexRect& changed, const Motion& motion) {
    const Vec2 middle((grid.x(changed.i0) + grid.x(changed.i1 - 1)) / 2,
                      (grid.y(changed.j0) + grid.y(changed.j1 - 1)) / 2);
    const Vec2 along(motion.end - motion.start);
    const double square = glm::dot(along, along);
    if (square == 0)
        return motion.end.z < motion.start.z ? motion.end : motion.start;
    const double t = glm::dot(middle - Vec2(motion.start), along) / square;
    return pointAt(motion, std::clamp(t, 0.0, 1.0));
}

/// The findings of a motion that has been cut, in the map of that moment.
void judge(const ZMap& zmap, const CutRecord& record, const Motion& motion, const Cutter& cutter,
           const ToolAssembly& assembly, bool unconfirmed, std::size_t block, FindingLog& findings) {
    if (motion.kind == MotionKind::rapid && !motion.known())
        judgeUnknownRapid(zmap, cutter, assembly, motion, block, findings);
    if (motion.kind == MotionKind::rapid && record.maxDepth > kNothingRemoved)
        findings.add(block, FindingKind::rapidCuts, record.maxDepth, unconfirmed,
                     overRemoved(zmap.grid(), record.changed, motion));
    if (cutter.fluteLength() > 0 && record.maxDepth > cutter.fluteLength() + kNothingRemoved)
        findings.add(block, FindingKind::depthBeyondFlutes, record.maxDepth, unconfirmed);
}

/// Whether a finding may depend on what the motion removes: judge().
bool mayBeFound(const ZMap& zmap, const Motion& motion, const Cutter& cutter) {
    return motion.kind == MotionKind::rapid ||
           (cutter.fluteLength() > 0 && zmap.stock().topZ() - bounds(motion).lo.z > cutter.fluteLength());
}

/// The cutter of a motion; null if it is unknown, or only probes.
const Cutter* cutterOf(const Motion& motion, const Setup& setup, const ToolChoice& tools) {
    return motion.probing ? nullptr : setup.tools.find(tools.tool(motion.tool));
}

/// Whether the sizes of the tool of a motion are not confirmed, or the tool is only assumed to be in the
/// spindle.
bool isUnconfirmed(const Motion& motion, const Setup& setup, const ToolChoice& tools) {
    return tools.isAssumed(motion.tool) || setup.tools.unconfirmedOrigin(tools.tool(motion.tool)) != nullptr;
}

/// The motions of a program with their cutters, one after the other from a certain one on. Whether a motion
/// continues the one before it depends on the program alone, so that a map does not depend on the blocks that
/// are cut at once.
class CutterMotions {
public:
    CutterMotions(const Program& program, std::size_t first, const Setup& setup, const ToolChoice& tools)
        : m_program(program), m_setup(setup), m_tools(tools) {
        continueAt(first);
    }
    void continueAt(std::size_t index) { m_last = index > 0 ? of(index - 1) : CutterMotion(); }
    /// The motion that follows the last one, marked by 1 + its block or another number.
    const CutterMotion& next(std::size_t index, std::size_t marked) {
        CutterMotion one = of(index);
        one.mark = static_cast<std::uint32_t>(marked + 1);
        one.continues = continues(m_last, one);
        return m_last = one;
    }

private:
    [[nodiscard]] CutterMotion of(std::size_t index) const {
        const Motion motion = m_program.motion(index);
        return {cutterOf(motion, m_setup, m_tools), motion};
    }

    const Program& m_program;
    const Setup& m_setup;
    const ToolChoice& m_tools;
    CutterMotion m_last;
};

/// Cuts one motion and adds the material left above the head of the cutter; that needs a snapshot of the map
/// and so is done only for cutters with a head. Nothing if it was stopped: the map may have been cut then.
std::optional<CutRecord> cutWithHead(ZMap& zmap, const CutterMotion& one, Overhang& overhang,
                                     const std::stop_token& stop) {
    const ZMapSnapshot before = zmap.snapshot();
    std::optional<CutRecord> record = cut(zmap, one, stop);
    if (!record)
        return record;
    const auto left = overhangLeft(before, zmap.snapshot(), record->changed, *one.cutter, one.motion, stop);
    if (!left)
        return std::nullopt;
    overhang.add(*left);
    return record;
}

} // namespace

std::optional<CutRecord> cutBlock(ZMap& zmap, const Program& program, std::size_t block, const Setup& setup,
                                  const ToolChoice& tools, FindingLog* findings,
                                  const std::stop_token& stop) {
    CutRecord sum;
    const auto motions = program.blockMotions(block);
    std::optional<ZMapSnapshot> before;
    Overhang overhang;
    bool unconfirmed = false; // the tool of the last motion: a block changes its tool before it moves
    ToolAssemblies assemblies;
    CutterMotions inTurn(program, motions.first, setup, tools);
    for (std::size_t index = motions.first; index < motions.last; ++index) {
        const CutterMotion& one = inTurn.next(index, block);
        const Motion& motion = one.motion;
        const Cutter* cutter = one.cutter;
        if (cutter == nullptr)
            continue;
        const bool measured = findings != nullptr && cutter->head();
        if (stop.stop_possible() && !before && (measured || motions.last - motions.first > 1))
            before = zmap.snapshot();
        std::optional<AssemblyContact> contact;
        if (findings != nullptr) {
            contact = assemblies.of(*cutter).contact(zmap, motion, stop);
            if (plungesWithCore(*cutter, motion))
                judgeCore(zmap, *cutter, motion, isUnconfirmed(motion, setup, tools), block, *findings);
        }
        std::optional<CutRecord> record;
        if (!stop.stop_requested()) // a motion with little work does not check, but a cycle has thousands
            record = measured ? cutWithHead(zmap, one, overhang, stop) : cut(zmap, one, stop);
        if (!record) {
            if (before)
                zmap = ZMap(*before);
            if (findings != nullptr)
                findings->truncate(block);
            return std::nullopt;
        }
        if (findings != nullptr) {
            unconfirmed = isUnconfirmed(motion, setup, tools);
            judge(*contact, unconfirmed, block, *findings);
            judge(zmap, *record, motion, *cutter, assemblies.of(*cutter), unconfirmed, block, *findings);
        }
        sum.add(*record);
    }
    if (findings != nullptr)
        judge(overhang, unconfirmed, block, *findings);
    return sum;
}

namespace {

/// Cuts blocks one after the other. Motions wait until one comes whose findings need the map of its moment;
/// those that wait are then cut at once.
class BlocksInTurn {
public:
    BlocksInTurn(ZMap& zmap, const Program& program, std::size_t first, std::size_t last, const Setup& setup,
                 const ToolChoice& tools, FindingLog* findings, const std::stop_token& stop,
                 PortionCutting& cutting, const BlockSet* recorded)
        : m_zmap(zmap), m_program(program), m_setup(setup), m_tools(tools), m_findings(findings),
          m_stop(stop), m_recorded(recorded), m_first(first), m_last(last), m_cutter(cutting.cutter),
          m_motions(program, first < last ? program.blockMotions(first).first : 0, setup, tools),
          m_waiting(cutting.motions), m_records(cutting.ofMotions), m_sums(cutting.ofBlocks) {
        m_waiting.clear();
        m_sums.assign(last - first, {});
    }

    /// False if it was stopped: the map may have been cut then.
    bool cutAll() {
        for (std::size_t block = m_first; block < m_last; ++block) {
            const std::size_t waiting = m_waiting.size();
            if (m_stop.stop_requested())
                return false;
            if (needsItsMoment(block) ? !cutWaiting(waiting) || !cutAlone(block) : !checkFrom(waiting))
                return false;
        }
        return cutWaiting(m_waiting.size());
    }

private:
    /// Adds the motions of a block to those that wait, unless one of them must be judged on the map of its
    /// moment: above a head material may remain, a rapid from an unknown position may end in the stock, and
    /// the core of a tool may meet it.
    bool needsItsMoment(std::size_t block) {
        const std::size_t waiting = m_waiting.size();
        const auto motions = m_program.blockMotions(block);
        for (std::size_t index = motions.first; index < motions.last; ++index) {
            CutterMotion one = m_motions.next(index, block);
            const Motion& motion = one.motion;
            const Cutter* cutter = one.cutter;
            if (cutter == nullptr)
                continue;
            if (m_findings != nullptr && (cutter->head() || plungesWithCore(*cutter, motion) ||
                                          (motion.kind == MotionKind::rapid && !motion.known()))) {
                m_waiting.resize(waiting);
                m_motions.continueAt(motions.last);
                return true;
            }
            one.recorded =
                m_recorded == nullptr || m_recorded->contains(block) || mayBeFound(m_zmap, motion, *cutter);
            m_waiting.push_back(one);
        }
        return false;
    }

    /// Finds the contacts of shanks and holders on the motions that wait, from index `first` on. Those before
    /// a motion must be cut first only if it has a contact without: on a lower map there is none that is not
    /// there on a higher one. After a motion with a contact the next one probably has one too.
    bool checkFrom(std::size_t first) {
        for (std::size_t k = first; m_findings != nullptr && k < m_waiting.size(); ++k) {
            if (!m_contacts.empty() && !cutBefore(k))
                return false;
            auto contact = contactOf(m_waiting[k]);
            if (contact && contact->any() && k > 0) {
                if (!cutBefore(k))
                    return false;
                contact = contactOf(m_waiting[k]);
            }
            if (!contact)
                return false;
            if (contact->any())
                m_contacts.emplace(k, *contact);
        }
        return true;
    }

    [[nodiscard]] std::optional<AssemblyContact> contactOf(const CutterMotion& waiting) {
        return m_assemblies.of(*waiting.cutter).contact(m_zmap, waiting.motion, m_stop);
    }

    /// Cuts those that wait before index `k`, which becomes that of the same motion.
    bool cutBefore(std::size_t& k) { return cutWaiting(std::exchange(k, 0)); }

    /// Cuts the first `count` of those that wait.
    bool cutWaiting(std::size_t count) {
        if (count == 0)
            return true;
        const std::span<const CutterMotion> motions = std::span(m_waiting).first(count);
        if (!m_cutter.cut(m_zmap, motions, m_records, m_stop))
            return false;
        for (std::size_t k = 0; k < count; ++k) {
            const Motion& motion = motions[k].motion;
            const std::size_t block = motions[k].mark - 1;
            if (const auto contact = m_contacts.find(k); contact != m_contacts.end())
                judge(contact->second, isUnconfirmed(motion, m_setup, m_tools), block, *m_findings);
            if (!motions[k].recorded)
                continue;
            const Cutter& cutter = *motions[k].cutter;
            if (m_findings != nullptr)
                judge(m_zmap, m_records[k], motion, cutter, m_assemblies.of(cutter),
                      isUnconfirmed(motion, m_setup, m_tools), block, *m_findings);
            m_sums[block - m_first].add(m_records[k]);
        }
        m_waiting.erase(m_waiting.begin(), m_waiting.begin() + static_cast<std::ptrdiff_t>(count));
        m_contacts.clear();
        return true;
    }

    bool cutAlone(std::size_t block) {
        const auto record = cutBlock(m_zmap, m_program, block, m_setup, m_tools, m_findings, m_stop);
        if (record)
            m_sums[block - m_first] = *record;
        return record.has_value();
    }

    ZMap& m_zmap;
    const Program& m_program;
    const Setup& m_setup;
    const ToolChoice& m_tools;
    FindingLog* m_findings;
    const std::stop_token& m_stop;
    const BlockSet* m_recorded; ///< null: all blocks
    std::size_t m_first;
    std::size_t m_last;
    SequenceCutter& m_cutter;
    CutterMotions m_motions;
    ToolAssemblies m_assemblies;
    std::vector<CutterMotion>& m_waiting;              ///< marked by 1 + their block
    std::map<std::size_t, AssemblyContact> m_contacts; ///< by index of those that wait
    std::vector<CutRecord>& m_records;                 ///< of those that waited last
    std::vector<CutRecord>& m_sums;                    ///< by block
};

void addMotions(const Program& program, std::size_t first, std::size_t last, const Setup& setup,
                const ToolChoice& tools, std::vector<CutterMotion>& motions) {
    if (first >= last)
        return;
    CutterMotions inTurn(program, program.blockMotions(first).first, setup, tools);
    for (std::size_t block = first; block < last; ++block) {
        const auto range = program.blockMotions(block);
        for (std::size_t index = range.first; index < range.last; ++index)
            motions.push_back(inTurn.next(index, block));
    }
}

} // namespace

std::optional<std::span<const CutRecord>> cutBlocksInTurn(ZMap& zmap, const Program& program,
                                                          std::size_t first, std::size_t last,
                                                          const Setup& setup, const ToolChoice& tools,
                                                          FindingLog* findings, const std::stop_token& stop,
                                                          PortionCutting& cutting, const BlockSet* recorded) {
    std::optional<ZMapSnapshot> before;
    if (stop.stop_possible())
        before = zmap.snapshot();
    BlocksInTurn blocks(zmap, program, first, last, setup, tools, findings, stop, cutting, recorded);
    if (blocks.cutAll())
        return cutting.ofBlocks;
    zmap = ZMap(*before);
    if (findings != nullptr)
        findings->truncate(first);
    return std::nullopt;
}

std::vector<CutterMotion> cutterMotions(const Program& program, std::size_t first, std::size_t last,
                                        const Setup& setup, const ToolChoice& tools) {
    std::vector<CutterMotion> motions;
    addMotions(program, first, last, setup, tools, motions);
    return motions;
}

void eachCutterMotion(const Program& program, Program::MotionRange range, const Setup& setup,
                      const ToolChoice& tools, const std::function<void(const CutterMotion&)>& visit) {
    CutterMotions inTurn(program, range.first, setup, tools);
    for (std::size_t index = range.first; index < range.last; ++index)
        visit(inTurn.next(index, index));
}

bool cutBlocks(ZMap& zmap, const Program& program, std::size_t first, std::size_t last, const Setup& setup,
               const ToolChoice& tools, const std::stop_token& stop, PortionCutting& cutting) {
    cutting.motions.clear();
    addMotions(program, first, last, setup, tools, cutting.motions);
    return cutting.cutter.cutHeights(zmap, GridPart(zmap.grid()), cutting.motions, stop);
}

} // namespace proveout
