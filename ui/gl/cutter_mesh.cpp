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
    ToolPart part;
};

class Outline {
public:
    [[nodiscard]] const std::vector<OutlineEdge>& edges() const { return m_edges; }

    void line(glm::dvec2 to, ToolPart part) {
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
        line(inwards ? outer : inner, ToolPart::flutes);
        if (piece.kind == PieceKind::line)
            line(inwards ? inner : outer, ToolPart::flutes);
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
            m_edges.push_back(
                {centre + piece.radius * a, centre + piece.radius * b, side * a, side * b, ToolPart::flutes});
        }
    }

    glm::dvec2 m_at{0, 0};
    std::vector<OutlineEdge> m_edges;
};

/// The flutes and what connects them with the shank; returns where they end.
double addFlutes(Outline& outline, const Cutter& cutter) {
    for (const ProfilePiece& piece : cutter.pieces())
        outline.piece(piece, false);
    const double end = std::max(cutter.fluteLength(), cutter.profileHeight());
    // The flutes may reach into the holder.
    const double shown = cutter.body().holder.empty() ? end : std::min(end, cutter.body().stickOut);
    if (const auto& head = cutter.head()) {
        for (std::size_t k = head->back.size(); k > 0; --k)
            outline.piece(head->back[k - 1], true);
        outline.line({head->neckRadius, shown}, ToolPart::shank);
    } else {
        outline.line({cutter.radius(), shown}, ToolPart::flutes);
    }
    return shown;
}

void addHolder(Outline& outline, const ToolBody& body) {
    double height = body.stickOut;
    for (const HolderSegment& segment : body.holder) {
        outline.line({segment.lowerRadius, height}, ToolPart::holder);
        height += segment.height;
        outline.line({segment.upperRadius, height}, ToolPart::holder);
    }
    outline.line({0, height}, ToolPart::holder);
}

Outline outline(const Cutter& cutter) {
    Outline outline;
    const ToolBody& body = cutter.body();
    const double flutesEnd = addFlutes(outline, cutter);
    const double shank = cutter.shankRadius() > 0 ? cutter.shankRadius() : cutter.radius();
    const double length = cutter.shankLength() > 0 ? cutter.shankLength() : flutesEnd;
    const double shankEnd = body.holder.empty() ? flutesEnd + length : body.stickOut;
    if (shankEnd > flutesEnd)
        outline.line({shank, flutesEnd}, ToolPart::shank);
    outline.line({shank, shankEnd}, ToolPart::shank);
    if (body.holder.empty())
        outline.line({0, shankEnd}, ToolPart::shank);
    else
        addHolder(outline, body);
    return outline;
}

CutterVertex revolved(glm::dvec2 point, glm::dvec2 normal, int sector, ToolPart part) {
    const double angle = 2 * std::numbers::pi * (sector % kSectors) / kSectors;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {{point.x * c, point.x * s, point.y},
            {normal.x * c, normal.x * s, normal.y},
            static_cast<float>(part)};
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

CutterExtent cutterExtent(const Cutter& cutter) {
    CutterExtent extent;
    const Outline profile = outline(cutter);
    for (const OutlineEdge& edge : profile.edges()) {
        extent.radius = std::max({extent.radius, edge.from.x, edge.to.x});
        extent.height = std::max({extent.height, edge.from.y, edge.to.y});
    }
    return extent;
}

} // namespace proveout
