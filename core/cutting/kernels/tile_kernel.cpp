// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled once per instruction set; the best version for the processor is selected when a function is first
// called.
#include "core/cutting/kernels/tile_kernel.h"

#include <bit>
#include <memory>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/cutting/kernels/tile_kernel.cpp"
// Before Highway, whose headers compile this file again for each target.
#include <hwy/foreach_target.h> // IWYU pragma: keep
#include <hwy/highway.h>

#include "core/cutting/kernels/block_by_all-inl.h"
#include "core/cutting/kernels/block_kernel-inl.h"
#include "core/cutting/kernels/tile_loss-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

TileLoss lowerByPass(const TilePass& pass, TileUnderWork& work, const PointWeights* weights) {
    BlockPlanes planes;
    std::uint32_t blocks = blocksAbove(pass, work.tile().blockMaxima.data(), work.floor(), planes);
    if (blocks == 0)
        return {};
    Losses losses(weights);
    withAnyEnvelope(pass, [&](const auto& envelope) HWY_ATTR {
        for (; blocks != 0; blocks &= blocks - 1) {
            const auto block = static_cast<std::size_t>(std::countr_zero(blocks));
            if (!work.isKnown(block))
                learnMaxima(work, block);
            const std::uint64_t strips =
                stripsAbove(planeOf(planes, block), work.columnMaxima(block, 0), work.floor());
            const auto collectorOf = [&](std::size_t group, std::size_t k) HWY_ATTR {
                return StripLosses(losses, pass, work, block, group, k);
            };
            if (strips != 0)
                lowerStrips(envelope, pass, work, block, strips, collectorOf);
        }
    });
    return losses.total();
}

void lowerBlockByPass(const TilePass& pass, const Plane& plane, TileUnderWork& work, std::size_t block) {
    const std::uint64_t strips = stripsAbove(plane, work.columnMaxima(block, 0), work.floor());
    if (strips == 0)
        return;
    withAnyEnvelope(pass, [&](const auto& envelope) HWY_ATTR {
        lowerStrips(envelope, pass, work, block, strips, [](std::size_t, std::size_t) { return NoLosses(); });
    });
}

/// The heights of a block before several passes.
struct BlockBefore {
    alignas(64) float heights[kBlock * kBlock];

    BlockBefore(const TileUnderWork& work, std::size_t block) {
        const float* from = work.heights(block, 0);
        for (std::size_t row = 0; row < kBlock; ++row) {
            for (std::size_t column = 0; column < kBlock; column += kLanes)
                hn::StoreU(hn::LoadU(kFloats, from + row * Tile::kSize + column), kFloats,
                           &heights[row * kBlock + column]);
        }
    }
    /// `pass`: any of the passes; they all have the same path.
    void compare(const TilePass& pass, const TileUnderWork& work, std::size_t block, Losses& losses) const {
        const BlockPlaces places(pass, block);
        for (std::size_t group = 0; group < kGroups; ++group) {
            const float* to = work.heights(block, group);
            for (std::size_t k = 0; k < kVectors; ++k) {
                StripLosses collector(losses, pass, work, block, group, k);
                for (std::size_t r = 0; r < kGroupRows; ++r) {
                    const std::size_t row = group * kGroupRows + r;
                    const V before = hn::LoadU(kFloats, &heights[row * kBlock + k * kLanes]);
                    const V now = hn::LoadU(kFloats, to + r * Tile::kSize + k * kLanes);
                    collector.add(r, before, now, hn::Lt(now, before), places.alongAt(row, k),
                                  places.acrossAt(row, k));
                }
                collector.end();
            }
        }
    }
};

TileLoss lowerByPasses(std::span<const TilePass> passes, TileUnderWork& work, const PointWeights* weights,
                       const std::stop_token& stop) {
    std::vector<BlockPlanes> planes(passes.size());
    std::vector<std::uint32_t> blocks(passes.size());
    std::uint32_t anyOf = 0;
    for (std::size_t k = 0; k < passes.size(); ++k) {
        blocks[k] = blocksAbove(passes[k], work.tile().blockMaxima.data(), work.floor(), planes[k]);
        anyOf |= blocks[k];
    }
    Losses losses(weights);
    for (; anyOf != 0 && !stop.stop_requested(); anyOf &= anyOf - 1) {
        const auto block = static_cast<std::size_t>(std::countr_zero(anyOf));
        if (!work.isKnown(block))
            learnMaxima(work, block);
        const BlockBefore before(work, block);
        for (std::size_t k = 0; k < passes.size(); ++k) {
            if ((blocks[k] >> block & 1U) != 0)
                lowerBlockByPass(passes[k], planeOf(planes[k], block), work, block);
        }
        before.compare(passes.front(), work, block, losses);
    }
    return losses.total();
}

TileLoss vectorLowerByMotion(std::span<const TilePass> passes, TileUnderWork& work,
                             const PointWeights* weights, const std::stop_token& stop) {
    return passes.size() == 1 ? lowerByPass(passes.front(), work, weights)
                              : lowerByPasses(passes, work, weights, stop);
}

bool vectorMayLower(std::span<const TilePass> passes, const Tile& tile, float floor) {
    BlockPlanes planes;
    for (const TilePass& pass : passes) {
        if (blocksAbove(pass, tile.blockMaxima.data(), floor, planes) != 0)
            return true;
    }
    return false;
}

void vectorFindRound(PassTable& table, const Tile& tile, float floor) {
    const std::span<const TilePass> rounds = table.passes().subspan(table.straightCount());
    for (std::size_t k = 0; k < rounds.size(); ++k) {
        PassTable::RoundPlanes& found = table.roundPlanes()[k];
        found.blocks = blocksAbove(rounds[k], tile.blockMaxima.data(), floor, found.planes);
    }
}

void vectorLowerBlockByAll(PassTable& table, TileUnderWork& work, std::size_t block) {
    BlockByAll(table, work, block).lower();
}

bool vectorFitBands(const TilePass& pass, LeadBands& bands) {
    return fitPassBands(pass, bands);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace proveout {

HWY_EXPORT(vectorMayLower);
HWY_EXPORT(vectorLowerByMotion);
HWY_EXPORT(vectorLowerBlockByAll);
HWY_EXPORT(vectorFindRound);
HWY_EXPORT(vectorFitBands);

std::shared_ptr<const LeadBands> leadBands(const TilePass& pass) {
    auto bands = std::make_shared<LeadBands>();
    if (!HWY_DYNAMIC_DISPATCH(vectorFitBands)(pass, *bands))
        return nullptr;
    return bands;
}

bool mayLower(std::span<const TilePass> passes, const Tile& tile, float floor) {
    return HWY_DYNAMIC_DISPATCH(vectorMayLower)(passes, tile, floor);
}

TileLoss lowerByMotion(std::span<const TilePass> passes, TileUnderWork& work, const PointWeights* weights,
                       const std::stop_token& stop) {
    return HWY_DYNAMIC_DISPATCH(vectorLowerByMotion)(passes, work, weights, stop);
}

bool lowerByAll(PassTable& table, TileUnderWork& work, const std::stop_token& stop) {
    HWY_DYNAMIC_DISPATCH(vectorFindRound)(table, work.tile(), work.floor());
    for (std::size_t block = 0; block < TileUnderWork::kBlocks; ++block) {
        if (stop.stop_requested())
            return false;
        HWY_DYNAMIC_DISPATCH(vectorLowerBlockByAll)(table, work, block);
    }
    return true;
}

} // namespace proveout
#endif
