// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/overhang.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/cutting/cut/sweep.h"

namespace proveout {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Two exact cuts may differ by a micrometre each, so a thinner layer of material does not count.
constexpr float kNothing = 2e-3F;
constexpr int kRow = 64; ///< the largest number of points that a sweep evaluates at once

using Row = std::array<float, kRow>;

/// Heights relative to the top of the stock.
struct Layer {
    float lo;
    float hi;
};

/// The back of a head turned upside down: a profile like any other, whose envelope is the highest position
/// that the back reaches, negated.
Cutter turnedOver(const NeckedHead& head) {
    CutterProfile profile{head.back, {}};
    for (ProfilePiece& piece : profile.pieces) {
        piece.z0 = -piece.z0;
        piece.z1 = -piece.z1;
        piece.centreZ = -piece.centreZ;
        if (piece.kind == PieceKind::upperArc)
            piece.kind = PieceKind::arc;
    }
    return {"", std::move(profile)};
}

Motion turnedOver(Motion motion) {
    for (Vec3* place : {&motion.start, &motion.end, &motion.centre})
        place->z = -place->z;
    if (motion.plane != Plane::xy)
        motion.sweep = -motion.sweep;
    return motion;
}

Cutter neckOf(const NeckedHead& head) {
    ProfilePiece disc;
    disc.r1 = head.neckRadius;
    return {"", CutterProfile{{disc}, {}}};
}

/// Splits an arc into pieces over each of which the head passes a place only once, or nearly at one height.
/// The pieces end at the eighths of its circle, because in a vertical plane the path over ground turns back
/// at quarters.
std::vector<Motion> partsOf(const Motion& motion) {
    constexpr double kEighth = std::numbers::pi / 4;
    if (motion.kind != MotionKind::arc || motion.sweep == 0 || !withinLimits(motion))
        return {motion};
    const auto [first, second, normal] = axes(motion.plane);
    const double from =
        std::atan2(motion.start[second] - motion.centre[second], motion.start[first] - motion.centre[first]) /
        kEighth;
    const double sweep = motion.sweep / kEighth;
    std::vector<double> ends;
    for (double k = std::ceil(std::min(from, from + sweep)); k < std::max(from, from + sweep); ++k)
        ends.push_back((k - from) / sweep);
    ends.push_back(1);
    std::ranges::sort(ends);
    std::vector<Motion> parts;
    double begin = 0;
    for (const double end : ends) {
        if (end <= begin)
            continue;
        Motion part = motion;
        part.start = pointAt(motion, begin);
        part.end = pointAt(motion, end);
        part.centre[normal] = part.start[normal];
        part.sweep = motion.sweep * (end - begin);
        parts.push_back(part);
        begin = end;
    }
    return parts;
}

/// The volume that one part of the motion sweeps: from its lower envelope up to the back of the head, and
/// without an upper limit where the neck passes.
struct HeadSweep {
    Sweep bottom;
    Sweep back;
    Sweep neck;

    HeadSweep(const Cutter& cutter, const Cutter& ofBack, const Cutter& ofNeck, const Motion& part,
              double topZ)
        : bottom(cutter, part, topZ), back(ofBack, turnedOver(part), -topZ), neck(ofNeck, part, topZ) {}

    [[nodiscard]] bool reaches(double x0, double x1, double y) const {
        const Box3& box = bottom.reach();
        return !bottom.empty() && box.lo.y <= y && y <= box.hi.y && box.lo.x <= x1 && x0 <= box.hi.x;
    }
};

void ask(const Sweep& sweep, const RowPoints& points, Row& out) {
    static constexpr Row kAboveAll = [] {
        Row row{};
        row.fill(1e30F); // so that no point is skipped
        return row;
    }();
    out.fill(kInfinity);
    (void)sweep.row(points, kAboveAll.data(), out.data());
}

/// The parts of the layer [lo, hi] that no other layer covers: their sum and where the lowest begins.
Layer uncovered(std::vector<Layer>& others, float lo, float hi) {
    std::ranges::sort(others, {}, &Layer::lo);
    float sum = 0;
    float lowest = hi;
    float reached = lo;
    const auto addUpTo = [&](float next) {
        if (next - reached <= kNothing)
            return;
        sum += next - reached;
        lowest = std::min(lowest, reached);
    };
    for (const Layer& layer : others) {
        addUpTo(std::min(layer.lo, hi));
        reached = std::max(reached, layer.hi);
    }
    addUpTo(hi);
    return {lowest, lowest + sum};
}

/// Measures the material left over the points of a row.
class RowMeasure {
public:
    RowMeasure(const ZMapSnapshot& before, const ZMapSnapshot& after, const std::vector<HeadSweep>& sweeps)
        : m_before(before), m_after(after), m_sweeps(sweeps) {}

    /// Columns [i0, i1), at most kRow.
    void measure(int j, int i0, int i1) {
        if (!anyLower(j, i0, i1))
            return;
        const Grid& grid = m_before.grid();
        const RowPoints points{grid.x(i0), grid.hx, grid.y(j), i1 - i0};
        for (auto* layers : {&m_swept, &m_byHead})
            for (std::vector<Layer>& layer : *layers)
                layer.clear();
        for (const HeadSweep& sweep : m_sweeps) {
            if (sweep.reaches(points.x, points.x + points.step * (points.count - 1), points.y))
                collect(sweep, points);
        }
        for (int i = i0; i < i1; ++i)
            judge(i, j, static_cast<std::size_t>(i - i0));
    }

    [[nodiscard]] const Overhang& sum() const { return m_sum; }

private:
    /// The box of a slanted motion holds many points that the motion does not touch.
    [[nodiscard]] bool anyLower(int j, int i0, int i1) const {
        for (int i = i0; i < i1; ++i) {
            if (m_after.height(i, j) < m_before.height(i, j))
                return true;
        }
        return false;
    }

    void collect(const HeadSweep& sweep, const RowPoints& points) {
        ask(sweep.bottom, points, m_bottom);
        ask(sweep.back, points, m_back);
        ask(sweep.neck, points, m_neck);
        for (std::size_t k = 0; k < static_cast<std::size_t>(points.count); ++k) {
            if (m_bottom[k] == kInfinity || m_back[k] == kInfinity)
                continue;
            const Layer head{m_bottom[k], -m_back[k]};
            m_byHead[k].push_back(head);
            m_swept[k].push_back(m_neck[k] == kInfinity ? head : Layer{head.lo, kInfinity});
        }
    }

    void judge(int i, int j, std::size_t k) {
        const float hi = m_before.height(i, j);
        const float lo = m_after.height(i, j);
        if (!(lo < hi))
            return;
        const bool underNeck =
            std::ranges::any_of(m_swept[k], [](const Layer& l) { return l.hi == kInfinity; });
        const Layer left = uncovered(m_swept[k], lo, hi);
        if (underNeck) {
            const Layer rubbed = uncovered(m_byHead[k], lo, hi);
            m_sum.neckDepth = std::max(m_sum.neckDepth, static_cast<double>(rubbed.hi - rubbed.lo));
        }
        add(i, j, left);
    }

    void add(int i, int j, const Layer& left) {
        const double height = static_cast<double>(left.hi) - static_cast<double>(left.lo);
        if (height <= 0)
            return;
        const Grid& grid = m_before.grid();
        const double weight =
            (i == 0 || i == grid.nx - 1 ? 0.5 : 1.0) * (j == 0 || j == grid.ny - 1 ? 0.5 : 1.0);
        m_sum.add({weight * height * grid.hx * grid.hy,
                   height,
                   {grid.x(i), grid.y(j), m_before.stock().topZ() + static_cast<double>(left.lo)},
                   0});
    }

    const ZMapSnapshot& m_before;
    const ZMapSnapshot& m_after;
    const std::vector<HeadSweep>& m_sweeps;
    Row m_bottom;
    Row m_back;
    Row m_neck;
    std::array<std::vector<Layer>, kRow> m_swept;
    std::array<std::vector<Layer>, kRow> m_byHead;
    Overhang m_sum;
};

} // namespace

void Overhang::add(const Overhang& other) {
    volumeMm3 += other.volumeMm3;
    neckDepth = std::max(neckDepth, other.neckDepth);
    if (other.height > height) {
        height = other.height;
        place = other.place;
    }
}

std::optional<Overhang> overhangLeft(const ZMapSnapshot& before, const ZMapSnapshot& after,
                                     const IndexRect& changed, const Cutter& cutter, const Motion& motion,
                                     const std::stop_token& stop) {
    if (!cutter.head() || changed.empty())
        return Overhang();
    const Cutter back = turnedOver(*cutter.head());
    const Cutter neck = neckOf(*cutter.head());
    std::vector<HeadSweep> sweeps;
    for (const Motion& part : partsOf(motion))
        sweeps.emplace_back(cutter, back, neck, part, before.stock().topZ());
    RowMeasure row(before, after, sweeps);
    for (int j = changed.j0; j < changed.j1; ++j) {
        for (int i = changed.i0; i < changed.i1; i += kRow) {
            if (stop.stop_requested())
                return std::nullopt;
            row.measure(j, i, std::min(i + kRow, changed.i1));
        }
    }
    return row.sum();
}

} // namespace proveout
