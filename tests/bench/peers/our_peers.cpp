// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/surface/surface.h"
#include "tests/bench/peers/peer.h"

namespace proveout::bench {

namespace {

PeerResult decimated(const PeerMap& map, const DecimationParameters& parameters) {
    const ZMapSnapshot zmap = test::zmapOf(map.nx, map.ny, map.spacing, map.heights);
    Surface surface(map.nx, map.ny, parameters);
    const double begin = cpuSeconds();
    surface.decimateDirty(zmap);
    const double seconds = cpuSeconds() - begin;
    return {surface.snapshot().triangles(), {}, seconds};
}

PeerResult certified(const PeerMap& map, double allowance, ErrorLevel level) {
    constexpr int kRegion = 64;
    return decimated(map, test::certifiedParameters(kRegion, allowance, level));
}

PeerResult leeAndLee(const PeerMap& map, double allowance, bool certify) {
    DecimationParameters parameters;
    parameters.method = DecimationMethod::lee;
    parameters.regionCells = 8;
    parameters.allowance = allowance;
    parameters.certify = certify;
    return decimated(map, parameters);
}

} // namespace

Peers ourPeers() {
    return {
        {"certified, surface level", "ε",
         [](const PeerMap& map, double allowance, std::size_t) {
             return certified(map, allowance, ErrorLevel::surface);
         }},
        {"certified, sample level", "ε",
         [](const PeerMap& map, double allowance, std::size_t) {
             return certified(map, allowance, ErrorLevel::sample);
         }},
        {"lee, with certify", "ε",
         [](const PeerMap& map, double allowance, std::size_t) { return leeAndLee(map, allowance, true); }},
        {"lee, to the letter", "ε",
         [](const PeerMap& map, double allowance, std::size_t) { return leeAndLee(map, allowance, false); }}};
}

} // namespace proveout::bench
