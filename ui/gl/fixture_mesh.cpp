// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/fixture_mesh.h"

#include <cmath>
#include <numbers>

#include "core/cutting/fixtures/fixture_surface.h"

namespace proveout {

namespace {

constexpr int kSectors = 64;

/// The corners of a flat polygon, counter-clockwise seen from outside, as a fan of triangles.
class Faces {
public:
    Faces(std::vector<SolidVertex>& out, float part) : m_out(out), m_part(part) {}

    void triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
        for (const Vec3& corner : {a, b, c})
            m_out.push_back({glm::vec3(corner), glm::vec3(normal), m_part});
    }
    /// A parallelogram.
    void side(const Vec3& corner, const Vec3& first, const Vec3& second) {
        const Vec3 normal = glm::normalize(glm::cross(first, second));
        triangle(corner, corner + first, corner + first + second, normal);
        triangle(corner, corner + first + second, corner + second, normal);
    }
    /// A quarter of a cylinder's wall, which is shaded as round.
    void wall(const Vec3& low, const Vec3& nextLow, const Vec3& up, const Vec3& normal, const Vec3& next) {
        add(low, normal);
        add(nextLow, next);
        add(nextLow + up, next);
        add(low, normal);
        add(nextLow + up, next);
        add(low + up, normal);
    }

private:
    void add(const Vec3& place, const Vec3& normal) {
        m_out.push_back({glm::vec3(place), glm::vec3(normal), m_part});
    }

    std::vector<SolidVertex>& m_out;
    float m_part;
};

void addSolid(Faces faces, const FixtureBox& box, const Vec3& origin) {
    const Vec3 low = Vec3(box.x, box.y, box.z) - origin;
    const Vec3 x(box.w, 0, 0);
    const Vec3 y(0, box.d, 0);
    const Vec3 z(0, 0, box.h);
    faces.side(low, y, x);
    faces.side(low, x, z);
    faces.side(low, z, y);
    faces.side(low + z, x, y);
    faces.side(low + y, z, x);
    faces.side(low + x, y, z);
}

void addSolid(Faces faces, const FixtureCylinder& cylinder, const Vec3& origin) {
    const Vec3 low = Vec3(cylinder.x, cylinder.y, cylinder.z) - origin;
    const Vec3 up(0, 0, cylinder.h);
    const auto direction = [](int sector) {
        const double angle = 2 * std::numbers::pi * (sector % kSectors) / kSectors;
        return Vec3(std::cos(angle), std::sin(angle), 0);
    };
    for (int sector = 0; sector < kSectors; ++sector) {
        const Vec3 here = direction(sector);
        const Vec3 next = direction(sector + 1);
        const Vec3 a = low + here * (cylinder.d / 2);
        const Vec3 b = low + next * (cylinder.d / 2);
        faces.wall(a, b, up, here, next);
        faces.triangle(low + up, a + up, b + up, {0, 0, 1});
        faces.triangle(low, b, a, {0, 0, -1});
    }
}

/// Each facet is flat. One without area has no normal, and nothing of it would be seen.
void addSolid(Faces faces, const FixtureMesh& mesh, const Vec3& origin) {
    if (!isUsable(mesh))
        return;
    const FixtureTurn turn(mesh.turn, mesh.scale);
    const Vec3 zero = Vec3(mesh.x, mesh.y, mesh.z) - origin;
    for (const FixtureFacet& facet : mesh.surface->facets()) {
        const Vec3 a = zero + turn(facet[0]);
        const Vec3 b = zero + turn(facet[1]);
        const Vec3 c = zero + turn(facet[2]);
        const Vec3 normal = glm::cross(b - a, c - a);
        if (const double area = glm::length(normal); area > 0)
            faces.triangle(a, b, c, normal / area);
    }
}

} // namespace

std::vector<SolidVertex> fixtureMesh(const Fixtures& fixtures, const Vec3& origin) {
    std::vector<SolidVertex> vertices;
    float part = 0;
    for (const auto& named : fixtures) {
        std::visit([&](const auto& shape) { addSolid(Faces(vertices, part), shape, origin); }, named.second);
        ++part;
    }
    return vertices;
}

} // namespace proveout
