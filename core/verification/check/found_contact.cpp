// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/check/found_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "core/cutter/body_profiles.h"
#include "core/cutting/fixtures/fixture_contact.h"
#include "core/simulation/run/cutting_findings.h"
#include "core/verification/findings/rule_findings.h"

namespace proveout {

namespace {

constexpr int kMoments = 4000; ///< at which a motion is looked at

/// What the place of a finding is.
enum class PlaceOf : std::uint8_t { tip, contact, fixture, lowest };

struct ContactRow {
    const FindingRow* row; ///< or one with the same id
    ToolPart part;         ///< that touches; that of a fixture is searched
    PlaceOf place;
};

constexpr std::array kContacts{
    ContactRow{&cutting_finding::kRapidCuts, ToolPart::flutes, PlaceOf::tip},
    ContactRow{&cutting_finding::kHolderCollision, ToolPart::holder, PlaceOf::contact},
    ContactRow{&cutting_finding::kShankCollision, ToolPart::shank, PlaceOf::contact},
    ContactRow{&cutting_finding::kNeckInStock, ToolPart::shank, PlaceOf::tip},
    ContactRow{&rule_finding::kDrillSideways, ToolPart::flutes, PlaceOf::tip},
    ContactRow{&rule_finding::kTableCollision, ToolPart::flutes, PlaceOf::lowest},
    ContactRow{&rule_finding::kFixtureCollision, ToolPart::flutes, PlaceOf::fixture},
    ContactRow{&rule_finding::kHolderNear, ToolPart::holder, PlaceOf::contact},
    ContactRow{&rule_finding::kShankNear, ToolPart::shank, PlaceOf::contact},
    ContactRow{&rule_finding::kFixtureNear, ToolPart::flutes, PlaceOf::fixture},
};

/// The lower surface of one part of a tool.
struct PartSurface {
    ToolPart part;
    Cutter surface;
};

std::vector<PartSurface> surfacesOf(const Cutter& cutter) {
    std::vector<PartSurface> surfaces{{ToolPart::flutes, cutter}};
    const auto add = [&](ToolPart part, std::vector<ProfilePiece> pieces) {
        if (!pieces.empty())
            surfaces.push_back({part, Cutter("", CutterProfile{std::move(pieces), {}})});
    };
    add(ToolPart::shank, shankProfile(cutter));
    add(ToolPart::holder, holderProfile(cutter));
    return surfaces;
}

double radiusOf(const Cutter& cutter, ToolPart part) {
    double radius = cutter.radius();
    for (const PartSurface& each : surfacesOf(cutter))
        if (each.part == part)
            radius = each.surface.radius();
    return radius;
}

/// The point of a fixture that is nearest to an axis, in plan.
Vec2 nearestOf(const FixtureBox& box, const Vec2& axis) {
    return glm::clamp(axis, Vec2(box.x, box.y), Vec2(box.x + box.w, box.y + box.d));
}
Vec2 nearestOf(const FixtureCylinder& cylinder, const Vec2& axis) {
    const Vec2 middle(cylinder.x, cylinder.y);
    const double away = glm::length(axis - middle);
    return away <= cylinder.d / 2 ? axis : middle + (axis - middle) * (cylinder.d / 2 / away);
}

/// Searches the motions of a block.
class BlockMoments {
public:
    BlockMoments(const Program& program, std::size_t block) : m_program(program), m_block(block) {}

    /// The first of the moments in which `off(tip)` is smallest.
    template<class Off>
    [[nodiscard]] Vec3 best(const Off& off) const {
        constexpr double kAlike = 1e-3; // mm
        const auto motions = m_program.blockMotions(m_block);
        Vec3 found = m_program.endOf(motions.last - 1);
        double least = off(found) - kAlike;
        for (std::size_t index = motions.first; index < motions.last; ++index) {
            const Motion motion = m_program.motion(index);
            for (int k = 0; motion.known() && k <= kMoments; ++k) {
                const Vec3 tip = pointAt(motion, static_cast<double>(k) / kMoments);
                if (const double here = off(tip); here < least) {
                    least = here - kAlike;
                    found = tip;
                }
            }
        }
        return found;
    }

private:
    const Program& m_program;
    std::size_t m_block;
};

/// The moment in which the lower surface of the part is at the place.
Vec3 tipAt(const BlockMoments& moments, const Cutter& cutter, ToolPart part, const Vec3& place) {
    for (const PartSurface& each : surfacesOf(cutter)) {
        if (each.part != part)
            continue;
        return moments.best([&](const Vec3& tip) {
            const double away = glm::length(Vec2(place) - Vec2(tip));
            const double beside = std::max(0.0, away - each.surface.radius());
            const double height = each.surface.height(std::min(away, each.surface.radius()));
            return std::abs(tip.z + height - place.z) + 10 * beside;
        });
    }
    return place;
}

/// The column of a mesh that the tool touches at rest.
FixtureBox touchedPart(const Vec3& tip, const Cutter& cutter, const FixtureMesh& mesh, double clearance) {
    Motion rest;
    rest.start = rest.end = tip;
    rest.startKnown = rest.endKnown = kAllAxes;
    const auto touched = columnContact(ToolOutline(cutter), rest, mesh, clearance);
    return touched ? touched->column : FixtureBox{.x = tip.x, .y = tip.y, .z = tip.z};
}
template<class Solid>
const Solid& touchedPart(const Vec3& /*tip*/, const Cutter& /*cutter*/, const Solid& solid,
                         double /*clearance*/) {
    return solid;
}

/// The lowest of the parts that reach the fixture, which counts as wider by `clearance`, touches it.
void meetFixture(FoundContact& contact, const Cutter& cutter, const Fixture& fixture, double clearance) {
    constexpr double kTouching = 1e-3; // mm
    const Vec2 axis(contact.tip);
    const auto [nearest, top] = std::visit(
        [&](const auto& shape) {
            const auto& part = touchedPart(contact.tip, cutter, shape, clearance);
            return std::pair(nearestOf(part, axis), part.z + part.h);
        },
        fixture);
    contact.place = Vec3(nearest, std::max(top, contact.tip.z));
    const double away = std::max(0.0, glm::length(nearest - axis) - clearance);
    double lowest = std::numeric_limits<double>::infinity();
    for (const PartSurface& each : surfacesOf(cutter)) {
        const double radius = each.surface.radius();
        const double height = each.surface.height(std::min(away, radius));
        if (away <= radius + kTouching && height < lowest) {
            lowest = height;
            contact.part = each.part;
        }
    }
}

} // namespace

std::optional<FoundContact> contactOf(const CheckFinding& finding, const Program& program,
                                      const Setup& setup) {
    const auto row = std::ranges::find_if(
        kContacts, [&](const ContactRow& each) { return hasIdOf(finding.diagnostic, *each.row); });
    const Cutter* cutter = setup.tools.find(finding.tool);
    if (row == kContacts.end() || cutter == nullptr || !finding.place || finding.worstBlock == 0 ||
        finding.worstBlock > program.blockCount())
        return std::nullopt;
    const BlockMoments moments(program, finding.worstBlock - 1);
    FoundContact contact{
        .block = finding.worstBlock - 1, .tip = *finding.place, .place = *finding.place, .part = row->part};
    if (row->place == PlaceOf::contact)
        contact.tip = tipAt(moments, *cutter, row->part, *finding.place);
    if (row->place == PlaceOf::lowest)
        contact.place = contact.tip = moments.best([](const Vec3& tip) { return tip.z; });
    if (row->place == PlaceOf::fixture) {
        constexpr std::size_t kName = 2; // the third argument of the sentence
        const auto& arguments = finding.diagnostic.arguments;
        const auto fixture =
            kName < arguments.size() ? setup.fixtures.find(arguments[kName].text()) : setup.fixtures.end();
        if (fixture == setup.fixtures.end())
            return std::nullopt;
        contact.fixture = fixture->first;
        const bool isNear = hasIdOf(finding.diagnostic, rule_finding::kFixtureNear);
        meetFixture(contact, *cutter, fixture->second, isNear ? finding.limit : 0);
    }
    contact.size = radiusOf(*cutter, contact.part);
    return contact;
}

} // namespace proveout
