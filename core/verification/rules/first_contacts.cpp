// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/rules/first_contacts.h"

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

} // namespace proveout
