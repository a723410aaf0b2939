// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/path_overview.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace proveout {
namespace {

constexpr std::size_t kMostPassed = 32; ///< motions per line; each new one is compared with all of them
constexpr std::size_t kMotionsBetweenLooks = 512;
constexpr int kMostChords = 64;
constexpr double kLeastSize = 1; // mm

double distanceFromLine(const Vec3& point, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double square = glm::dot(along, along);
    const double t = square > 0 ? std::clamp(glm::dot(point - a, along) / square, 0.0, 1.0) : 0;
    return glm::distance(point, a + along * t);
}

int chords(const Motion& motion, double tolerance) {
    if (motion.kind != MotionKind::arc)
        return 1;
    const double radius = std::max(arcRadius(motion), tolerance);
    const double angle = 2 * std::acos(std::max(1 - tolerance / radius, 0.5));
    return std::clamp(static_cast<int>(std::ceil(std::abs(motion.sweep) / angle)), 1, kMostChords);
}

} // namespace

bool PathOverview::setProgram(std::shared_ptr<const Program> program) {
    if (program == m_program)
        return false;
    m_program = std::move(program);
    const bool known = m_program != nullptr && !m_program->bounds().empty();
    m_origin = known ? m_program->bounds().lo : Vec3(0);
    const double size = known ? glm::distance(m_program->bounds().lo, m_program->bounds().hi) : 0;
    m_coarse = false;
    restart(kShareOfSize * std::max(size, kLeastSize));
    return true;
}

void PathOverview::restart(double tolerance) {
    m_tolerance = tolerance;
    m_next = 0;
    m_nextMotion = 0;
    m_vertices.clear();
    m_blocks.clear();
    m_length = 0;
    m_passed.clear();
}

void PathOverview::advance(const UploadBudget& budget) {
    while (!whole()) {
        addSome();
        if (whole())
            finishLine();
        if (m_blocks.size() > kMostLines) {
            m_coarse = true;
            restart(2 * m_tolerance);
        }
        if (budget.spent())
            return;
    }
}

/// Checks after a number of motions and not of blocks, because one block may have a hundred thousand motions.
void PathOverview::addSome() {
    for (std::size_t count = 0; count < kMotionsBetweenLooks && !whole(); ++count) {
        const Program::MotionRange motions = m_program->blockMotions(m_next);
        m_nextMotion = std::max(m_nextMotion, motions.first);
        if (m_nextMotion < motions.last)
            add(m_program->motion(m_nextMotion++), static_cast<std::uint32_t>(m_next));
        if (m_nextMotion >= motions.last)
            ++m_next;
    }
}

void PathOverview::add(const Motion& motion, std::uint32_t block) {
    if (!motion.known())
        return finishLine();
    if (m_passed.empty() || m_passed.back() != motion.start) {
        finishLine();
        m_from = motion.start;
    }
    const int count = chords(motion, m_tolerance);
    for (int k = 1; k <= count; ++k)
        lineTo(pointAt(motion, static_cast<double>(k) / count), motion.kind, block);
}

void PathOverview::lineTo(const Vec3& point, MotionKind kind, std::uint32_t block) {
    const bool on = !m_passed.empty() && kind == m_kind && m_passed.size() < kMostPassed && isNearLine(point);
    if (!on && !m_passed.empty()) {
        const Vec3 end = m_passed.back();
        finishLine();
        m_from = end;
    }
    if (m_passed.empty()) {
        m_kind = kind;
        m_block = block;
    }
    m_passed.push_back(point);
}

bool PathOverview::isNearLine(const Vec3& end) const {
    return std::ranges::all_of(
        m_passed, [&](const Vec3& point) { return distanceFromLine(point, m_from, end) <= m_tolerance; });
}

void PathOverview::finishLine() {
    if (m_passed.empty())
        return;
    const Vec3 to = m_passed.back();
    const double length = glm::distance(m_from, to);
    m_passed.clear();
    if (length == 0 || (m_coarse && length < m_tolerance))
        return;
    const auto kind = static_cast<float>(m_kind);
    m_vertices.push_back({glm::vec3(m_from - m_origin), 0, kind});
    m_vertices.push_back({glm::vec3(to - m_origin), static_cast<float>(length), kind});
    m_blocks.push_back(m_block);
    m_length += length;
}

std::size_t PathOverview::verticesBefore(std::size_t block) const {
    return 2 * static_cast<std::size_t>(std::ranges::lower_bound(m_blocks, block) - m_blocks.begin());
}

double PathOverview::coveragePerMm() const {
    if (m_program == nullptr || m_program->bounds().empty())
        return 0;
    const Vec3 size = m_program->bounds().hi - m_program->bounds().lo;
    const double area = std::max({size.x * size.y, size.x * size.z, size.y * size.z, kLeastSize});
    return m_length / area;
}

} // namespace proveout
