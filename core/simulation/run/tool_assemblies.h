// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "core/cutter/cutter.h"
#include "core/cutting/cut/assembly_contact.h"

namespace proveout {

/// The shanks and holders of the cutters in use, each prepared when it is first needed. The cutters must
/// outlive it. Owned by one thread.
class ToolAssemblies {
public:
    [[nodiscard]] const ToolAssembly& of(const Cutter& cutter) {
        if (&cutter != m_lastCutter) {
            m_lastCutter = &cutter;
            m_last = &m_assemblies.try_emplace(&cutter, cutter).first->second;
        }
        return *m_last;
    }

private:
    std::map<const Cutter*, ToolAssembly> m_assemblies;
    const Cutter* m_lastCutter = nullptr;
    const ToolAssembly* m_last = nullptr;
};

} // namespace proveout
