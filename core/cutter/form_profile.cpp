// SPDX-License-Identifier: GPL-3.0-or-later
// A free profile, written as points from the tip outwards: RADIUS/HEIGHT:RADIUS/HEIGHT:… An arc to a point is
// written RADIUS/HEIGHT@RADIUS/HEIGHT with its centre, or RADIUS/HEIGHT@R with its radius, which is negative
// for a hollow in the cutter.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <optional>

#include "core/base/figures_argument.h"
#include "core/base/geometry.h"
#include "core/cutter/cutter_findings.h"
#include "core/cutter/shape_profiles.h"
#include "core/cutter/solvable_pieces.h"

namespace proveout {

namespace {

/// Each piece is a pass of cutting, and a hollow consists of many pieces.
constexpr std::size_t kMostPoints = 200;
constexpr std::size_t kMostPieces = 1000;
constexpr double kLargestPlace = 10000; // mm
/// The ends of an arc that is written with three decimals can be that far from a circle.
constexpr double kRoundedPlace = 2e-3;
/// Radii that differ by less count as the same, so that the line between them is vertical.
constexpr double kSameRadius = 1e-6;

std::optional<double> numberOf(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(std::abs(value) <= kLargestPlace))
        return {};
    return value;
}

/// Radius and height.
std::optional<Vec2> placeOf(std::string_view text) {
    const auto slash = text.find('/');
    if (slash == std::string_view::npos)
        return {};
    const auto radius = numberOf(text.substr(0, slash));
    const auto height = numberOf(text.substr(slash + 1));
    if (!radius || !height)
        return {};
    return Vec2(*radius, *height);
}

/// Whether an arc rises all the way, from horizontal to vertical at most.
bool withinQuarter(const ProfilePiece& arc) {
    if (arc.kind == PieceKind::arc)
        return arc.centreR <= arc.r0 + kRoundedPlace && arc.centreZ >= arc.z1 - kRoundedPlace;
    return arc.centreR >= arc.r1 - kRoundedPlace && arc.centreZ <= arc.z0 + kRoundedPlace;
}

/// Reads point by point; error places are reported as characters of the text, counted from 1.
class FormReader {
public:
    explicit FormReader(std::string_view text) : m_text(text) {}

    Result<CutterProfile> read() {
        for (std::size_t at = 0; at <= m_text.size(); ++m_points) {
            const auto end = std::min(m_text.find(':', at), m_text.size());
            m_at = at;
            if (auto added = addPoint(m_text.substr(at, end - at)); !added)
                return tl::unexpected(std::move(added.error()));
            at = end + 1;
        }
        if (m_profile.pieces.empty())
            return fail(cutter_finding::kFormNoWidth);
        return std::move(m_profile);
    }

private:
    [[nodiscard]] tl::unexpected<Diagnostics> fail(const FindingRow& row,
                                                   std::vector<Argument> more = {}) const {
        more.insert(more.begin(), std::to_string(m_at + 1));
        return failure(row, std::move(more));
    }

    Result<void> addPoint(std::string_view text) {
        if (m_points == kMostPoints)
            return fail(cutter_finding::kFormTooLong, {std::to_string(kMostPoints)});
        const auto at = text.find('@');
        const auto place = placeOf(text.substr(0, at));
        if (!place)
            return unreadable(text);
        if (m_points == 0)
            return begin(*place, text);
        if (place->x < m_last.x)
            return fail(cutter_finding::kFormTurnsBack);
        if (place->y < m_last.y)
            return fall();
        auto added =
            at == std::string_view::npos ? addLine(*place) : addArc(*place, text.substr(at + 1), text);
        m_last = *place;
        return added;
    }

    [[nodiscard]] tl::unexpected<Diagnostics> unreadable(std::string_view text) const {
        return fail(cutter_finding::kFormUnreadable,
                    {std::string(text.substr(0, 40)), "5/2", "5/2@3/2", "5/2@2"});
    }

    [[nodiscard]] tl::unexpected<Diagnostics> fall() const { return fail(cutter_finding::kFormFalls); }

    Result<void> begin(const Vec2& place, std::string_view text) {
        if (place != Vec2(0) || text.find('@') != std::string_view::npos)
            return fail(cutter_finding::kFormStart, {std::string(text.substr(0, 40)), "0/0"});
        return {};
    }

    Result<void> addLine(const Vec2& to) {
        if (to.x - m_last.x > kSameRadius)
            return add(sideBetween(m_last.x, m_last.y, to.x, to.y));
        m_wall = m_wall || to.y > m_last.y;
        return {};
    }

    Result<void> addArc(const Vec2& to, std::string_view round, std::string_view text) {
        const Vec2 chord = to - m_last;
        if (chord.x <= kSameRadius || chord.y <= kSameRadius)
            return turns();
        const Vec2 inwards = glm::normalize(Vec2(-chord.y, chord.x)); // away from the tip plane
        const Vec2 middle = (m_last + to) / 2.0;
        Result<double> away = 0; // of the centre from the midpoint of the chord
        if (const auto radius = numberOf(round))
            away = awayByRadius(*radius, glm::length(chord));
        else if (const auto centre = placeOf(round))
            away = awayByCentre(*centre, to, inwards);
        else
            return unreadable(text);
        if (!away)
            return tl::unexpected(std::move(away.error()));
        ProfilePiece arc = sideBetween(m_last.x, m_last.y, to.x, to.y);
        const Vec2 centre = middle + inwards * *away;
        arc.kind = *away > 0 ? PieceKind::arc : PieceKind::upperArc;
        arc.centreR = centre.x;
        arc.centreZ = centre.y;
        arc.radius = glm::distance(centre, to);
        if (!withinQuarter(arc))
            return turns();
        return add(arc);
    }

    [[nodiscard]] Result<double> awayByRadius(double radius, double chord) const {
        if (2 * std::abs(radius) < chord)
            return fail(cutter_finding::kFormArcRadius, {figures("{}", radius), figures("{:.6g}", chord)});
        return std::copysign(std::sqrt(radius * radius - chord * chord / 4), radius);
    }

    [[nodiscard]] Result<double> awayByCentre(const Vec2& centre, const Vec2& to, const Vec2& inwards) const {
        const double from = glm::distance(centre, m_last);
        const double until = glm::distance(centre, to);
        if (std::abs(from - until) > kRoundedPlace)
            return fail(cutter_finding::kFormArcCentre, {figures("{:.6g}", from), figures("{:.6g}", until)});
        return glm::dot(centre - (m_last + to) / 2.0, inwards);
    }

    [[nodiscard]] tl::unexpected<Diagnostics> turns() const { return fail(cutter_finding::kFormArcTurns); }

    Result<void> add(const ProfilePiece& piece) {
        if (m_profile.pieces.empty() && m_wall)
            return fail(cutter_finding::kFormNoTip);
        m_profile.pieces.push_back(piece);
        m_solvable += solvablePieces({piece}).size();
        if (m_solvable > kMostPieces)
            return fail(cutter_finding::kFormTooFine, {std::to_string(kMostPieces)});
        return {};
    }

    std::string_view m_text;
    std::size_t m_at = 0; ///< position in m_text of the point that is being read
    std::size_t m_points = 0;
    std::size_t m_solvable = 0;
    Vec2 m_last{0};
    bool m_wall = false; ///< whether there has been a vertical part
    CutterProfile m_profile;
};

} // namespace

Result<CutterProfile> formProfile(const ShapeValues& values) {
    return FormReader(values.text).read();
}

} // namespace proveout
