// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/state/modal_saves.h"

#include "core/nc/codes/modal_groups.h"
#include "core/nc/state/active_codes.h"

namespace proveout {

namespace {

Block blockOf(const Word& place, char letter, double value) {
    Block block;
    static_cast<void>(block.add({letter, value, place.column, place.length, true}));
    return block;
}

/// For LinuxCNC, flood coolant is not a separate mode: without mist, it only means that mist is off.
void addCoolant(const MachineState& from, const MachineState& to, const Word& place,
                std::vector<Block>& blocks) {
    constexpr double kMist = 7;
    constexpr double kFlood = 8;
    constexpr double kOff = 9;
    if (to.mist && !from.mist)
        blocks.push_back(blockOf(place, 'M', kMist));
    if (to.flood && !from.flood)
        blocks.push_back(blockOf(place, 'M', kFlood));
    if (!to.mist && !to.flood && (from.mist || from.flood))
        blocks.push_back(blockOf(place, 'M', kOff));
}

} // namespace

void ModalSaves::save(std::size_t level, const MachineState& state, bool untilReturn) {
    if (m_saves.size() <= level)
        m_saves.resize(level + 1);
    std::optional<Save>& save = m_saves[level];
    // M70 after M73 changes the saved state, but it is still restored.
    save = Save{state, untilReturn || (save && save->untilReturn)};
}

void ModalSaves::discard(std::size_t level) {
    if (level < m_saves.size())
        m_saves[level].reset();
}

const MachineState* ModalSaves::at(std::size_t level) const {
    return level < m_saves.size() && m_saves[level] ? &m_saves[level]->state : nullptr;
}

std::optional<MachineState> ModalSaves::endRun(std::size_t level) {
    std::optional<MachineState> state;
    if (level < m_saves.size() && m_saves[level] && m_saves[level]->untilReturn)
        state = m_saves[level]->state;
    discard(level);
    return state;
}

std::vector<Block> blocksToRestore(const MachineState& from, const MachineState& to, const Dialect& dialect,
                                   const Word& word) {
    std::vector<Block> blocks;
    // The units come before all others, because the feed is in them.
    if (from.inch != to.inch)
        blocks.push_back(blockOf(word, 'G', restoringCode(to, ModalGroup::units, dialect)));
    Block block;
    const auto restore = [&](char letter, double before, double value) {
        if (before != value)
            static_cast<void>(block.add({letter, value, word.column, word.length, true}));
    };
    for (const ModalGroupRow& row : modalGroups())
        if ((row.readers & kReadByRestore) != 0)
            restore(row.letter, restoringCode(from, row.group, dialect),
                    restoringCode(to, row.group, dialect));
    restore('F', from.feedNumber, to.feedNumber);
    restore('S', from.spindleRpm, to.spindleRpm);
    if (!block.empty())
        blocks.push_back(block);
    addCoolant(from, to, word, blocks);
    return blocks;
}

} // namespace proveout
