// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/state/modal_saves.h"

#include <array>

namespace proveout {

namespace {

double feedModeCode(const MachineState& state) {
    constexpr std::array kCodes{94.0, 93.0, 95.0};
    return kCodes[static_cast<std::size_t>(state.feedMode)];
}

double planeCode(const MachineState& state) {
    constexpr std::array kCodes{17.0, 18.0, 19.0};
    return kCodes[static_cast<std::size_t>(state.plane)];
}

double compensationCode(const MachineState& state) {
    if (!state.compensation.on)
        return 40;
    return state.compensation.side >= 0 ? 41 : 42;
}

double workOffsetCode(const MachineState& state) {
    constexpr int kWhole = 6; ///< G54 to G59; G59.1 follows
    return state.workOffset <= kWhole ? 53.0 + state.workOffset : 59.0 + 0.1 * (state.workOffset - kWhole);
}

/// LinuxCNC takes an offset of nothing for none, and restores any other as that of the tool in the spindle.
double toolLengthCode(const MachineState& state) {
    return state.toolOffset == Vec3(0) ? 49 : 43;
}

double spindleCode(const MachineState& state) {
    if (state.spindleDirection == 0)
        return 5;
    return state.spindleDirection > 0 ? 3 : 4;
}

/// The modes that come back together, by one block. The units come before: the feed counts in them.
struct Mode {
    char letter;
    double (*code)(const MachineState&);
};
constexpr Mode kModes[] = {
    {'G', feedModeCode},
    {'G', [](const MachineState& s) { return s.surfaceSpeed ? 96.0 : 97.0; }},
    {'F', [](const MachineState& s) { return s.feedNumber; }},
    {'S', [](const MachineState& s) { return s.spindleRpm; }},
    {'M', spindleCode},
    {'G', planeCode},
    {'G', compensationCode},
    {'G', toolLengthCode},
    {'G', workOffsetCode},
    {'G', [](const MachineState& s) { return s.incremental ? 91.0 : 90.0; }},
    {'G', [](const MachineState& s) { return s.arcCentreAbsolute ? 90.1 : 91.1; }},
    {'G', [](const MachineState& s) { return s.retractToR ? 99.0 : 98.0; }},
    {'G', [](const MachineState& s) { return s.shifted ? 92.3 : 92.2; }},
};

Block blockOf(const Word& place, char letter, double value) {
    Block block;
    static_cast<void>(block.add({letter, value, place.column, place.length, true}));
    return block;
}

/// Flood coolant is no mode of its own to LinuxCNC: without mist, it only says that mist is not asked for.
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
    // M70 behind M73 changes what comes back, not that it does.
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

std::vector<Block> blocksToRestore(const MachineState& from, const MachineState& to, const Word& word) {
    std::vector<Block> blocks;
    if (from.inch != to.inch)
        blocks.push_back(blockOf(word, 'G', to.inch ? 20 : 21));
    Block block;
    for (const Mode& mode : kModes) {
        if (mode.code(from) != mode.code(to))
            static_cast<void>(block.add({mode.letter, mode.code(to), word.column, word.length, true}));
    }
    if (!block.empty())
        blocks.push_back(block);
    addCoolant(from, to, word, blocks);
    return blocks;
}

} // namespace proveout
