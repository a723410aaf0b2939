// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/zmap/grid_part.h"

namespace proveout {

/// Cuts sequences of motions, call after call, in memory that it keeps for the next call: up to 60 MB, which
/// would otherwise be taken from the system and given back each time. Owned by one thread.
class SequenceCutter {
public:
    SequenceCutter();
    ~SequenceCutter();
    SequenceCutter(const SequenceCutter&) = delete;
    SequenceCutter& operator=(const SequenceCutter&) = delete;

    /// cut() of a sequence; `records` becomes its result, one per motion. False if it was stopped.
    [[nodiscard]] bool cut(ZMap& zmap, std::span<const CutterMotion> motions, std::vector<CutRecord>& records,
                           const std::stop_token& stop, Provenance* provenance = nullptr);
    /// cutHeights() of a sequence on a map whose points are those of `place` (cut_part.h).
    [[nodiscard]] bool cutHeights(ZMap& zmap, const GridPart& place, std::span<const CutterMotion> motions,
                                  const std::stop_token& stop);

private:
    class Portion;
    template<class Lower>
    bool byPortions(ZMap& zmap, std::span<const CutterMotion> motions, const std::stop_token& stop,
                    const Lower& lower);

    std::unique_ptr<Portion> m_portion;
};

} // namespace proveout
