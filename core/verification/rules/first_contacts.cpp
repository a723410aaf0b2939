// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/rules/first_contacts.h"

#include <map>
#include <set>

namespace proveout {

std::vector<FirstContact> firstContacts(const CheckedRun& run) {
    std::vector<FirstContact> contacts;
    std::set<int> known;
    for (std::size_t block = 0; block < run.rows.size(); ++block) {
        if (!run.rows[block].cuts() || !known.insert(run.toolOf(block)).second)
            continue;
        FirstContact contact{run.toolOf(block), block, Vec3(0)};
        const auto motions = run.program.blockMotions(block);
        for (std::size_t index = motions.last; index-- > motions.first;)
            if (const Motion motion = run.program.motion(index); motion.known())
                contact.start = motion.start;
        contacts.push_back(contact);
    }
    return contacts;
}

/// Most tools touch the stock soon after they are called; if one does not, all its blocks up to a contact are
/// needed.
void needForFirstContacts(const CheckedRun& run, BlockSet& out) {
    constexpr std::size_t kSoon = 64;
    std::map<int, std::size_t> blocks; // by tool: how many it has had before its first known contact
    std::set<int> touching;
    for (std::size_t block = 0; block < run.program.blockCount(); ++block) {
        const int tool = run.toolOf(block);
        if (touching.contains(tool) || run.setup.tools.find(tool) == nullptr)
            continue;
        if (run.isRecorded(block) && run.rows[block].cuts())
            touching.insert(tool);
        else if (!run.isRecorded(block) && (run.isDone() || blocks[tool]++ < kSoon))
            out.add(block);
    }
}

} // namespace proveout
