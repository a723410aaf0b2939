// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/cutter_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace proveout {
namespace {

constexpr int kSectors = 48;
constexpr int kArcSteps = 14;

/// One segment of the outline in the r-z plane, from the tip to the top, with the outward normals at its
/// ends.
struct OutlineEdge {
    glm::dvec2 from;
    glm::dvec2 to;
    glm::dvec2 normalFrom;
    glm::dvec2 normalTo;
    float part;
};

class Outline {
public:
    [[nodiscard]] const std::vector<OutlineEdge>& edges() const { return m_edges; }

    void line(glm::dvec2 to, float part) {
        const glm::dvec2 along = to - m_at;
        if (const double length = std::hypot(along.x, along.y); length > 1e-9) {
            const glm::dvec2 normal = glm::dvec2(along.y, -along.x) / length;
            m_edges.push_back({m_at, to, normal, normal, part});
        }
        m_at = to;
    }

    /// Adds a piece of the profile, or of the back of a slot cutter or lollipop, from one of its radii to the
    /// other. If the outline does not end where the piece starts, a straight wall connects them.
    void piece(const ProfilePiece& piece, bool inwards) {
        const glm::dvec2 inner(piece.r0, piece.z0);
        const glm::dvec2 outer(piece.r1, piece.z1);
        line(inwards ? outer : inner, 0);
        if (piece.kind == PieceKind::line)
            line(inwards ? inner : outer, 0);
        else
            arc(piece, inwards);
        m_at = inwards ? inner : outer;
    }

private:
    void arc(const ProfilePiece& piece, bool inwards) {
        const glm::dvec2 centre(piece.centreR, piece.centreZ);
        const double up = piece.kind == PieceKind::upperArc ? 1 : -1;
        const auto angleAt = [&](double r) {
            return std::acos(std::clamp((r - centre.x) / piece.radius, -1.0, 1.0));
        };
        const double first = angleAt(inwards ? piece.r1 : piece.r0);
        const double last = angleAt(inwards ? piece.r0 : piece.r1);
        const auto direction = [&](int step) {
            const double angle = first + (last - first) * step / kArcSteps;
            return glm::dvec2(std::cos(angle), up * std::sin(angle));
        };
        // The normal of a concave arc points towards its centre, that of any other arc away from it.
        const double side = up > 0 && !inwards ? -1 : 1;
        for (int step = 0; step < kArcSteps; ++step) {
            const glm::dvec2 a = direction(step);
            const glm::dvec2 b = direction(step + 1);
            m_edges.push_back({centre + piece.radius * a, centre + piece.radius * b, side * a, side * b, 0});
        }
    }

    glm::dvec2 m_at{0, 0};
    std::vector<OutlineEdge> m_edges;
};

Outline outline(const Cutter& cutter) {
    Outline outline;
    for (const ProfilePiece& piece : cutter.pieces())
        outline.piece(piece, false);
    const double flutesEnd = std::max(cutter.fluteLength(), cutter.profileHeight());
    if (const auto& head = cutter.head()) {
        for (std::size_t k = head->back.size(); k > 0; --k)
            outline.piece(head->back[k - 1], true);
        outline.line({head->neckRadius, flutesEnd}, 1);
    } else {
        outline.line({cutter.radius(), flutesEnd}, 0);
    }
    const double shank = cutter.shankRadius() > 0 ? cutter.shankRadius() : cutter.radius();
    const double length = cutter.shankLength() > 0 ? cutter.shankLength() : flutesEnd;
    outline.line({shank, flutesEnd}, 1);
    outline.line({shank, flutesEnd + length}, 1);
    outline.line({0, flutesEnd + length}, 1);
    return outline;
}

CutterVertex revolved(glm::dvec2 point, glm::dvec2 normal, int sector, float part) {
    const double angle = 2 * std::numbers::pi * (sector % kSectors) / kSectors;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {{point.x * c, point.x * s, point.y}, {normal.x * c, normal.x * s, normal.y}, part};
}

} // namespace

std::vector<CutterVertex> cutterMesh(const Cutter& cutter) {
    std::vector<CutterVertex> vertices;
    const Outline profile = outline(cutter);
    for (const OutlineEdge& edge : profile.edges())
        for (int sector = 0; sector < kSectors; ++sector) {
            const CutterVertex a = revolved(edge.from, edge.normalFrom, sector, edge.part);
            const CutterVertex b = revolved(edge.from, edge.normalFrom, sector + 1, edge.part);
            const CutterVertex c = revolved(edge.to, edge.normalTo, sector + 1, edge.part);
            const CutterVertex d = revolved(edge.to, edge.normalTo, sector, edge.part);
            if (edge.from.x > 0)
                vertices.insert(vertices.end(), {a, b, c});
            if (edge.to.x > 0)
                vertices.insert(vertices.end(), {a, c, d});
        }
    return vertices;
}

} // namespace proveout
