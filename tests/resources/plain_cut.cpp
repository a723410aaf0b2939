// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/resources/plain_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numbers>
#include <sstream>

namespace proveout::samples {

namespace {

constexpr double kStep = 0.2;
constexpr double kBallRadius = 5.5;

std::map<char, double> wordsOf(const std::string& block) {
    std::map<char, double> words;
    std::istringstream stream(block);
    for (std::string word; stream >> word;)
        words[word[0]] = std::strtod(word.c_str() + 1, nullptr);
    return words;
}

Vec3 onArc(const Vec3& from, const Vec3& to, const Vec2& centre, bool clockwise, double t) {
    const double a0 = std::atan2(from.y - centre.y, from.x - centre.x);
    double sweep = std::atan2(to.y - centre.y, to.x - centre.x) - a0;
    if (clockwise && sweep >= -1e-9)
        sweep -= 2 * std::numbers::pi;
    if (!clockwise && sweep <= 1e-9)
        sweep += 2 * std::numbers::pi;
    const double radius = glm::distance(Vec2(from), centre);
    const double angle = a0 + t * sweep;
    return {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle),
            from.z + t * (to.z - from.z)};
}

} // namespace

std::vector<PlainMove> readMoves(const std::string& program) {
    std::vector<PlainMove> moves;
    std::istringstream stream(program);
    Vec3 at(std::numeric_limits<double>::quiet_NaN());
    int code = -1;
    int line = 0;
    for (std::string block; std::getline(stream, block);) {
        ++line;
        if (block.empty() || std::string("GXYZI").find(block[0]) == std::string::npos)
            continue;
        const std::map<char, double> words = wordsOf(block);
        if (words.count('G') != 0 && words.at('G') > 3)
            continue;
        if (words.count('G') != 0)
            code = static_cast<int>(words.at('G'));
        Vec3 to = at;
        for (int axis = 0; axis < 3; ++axis)
            if (const auto word = words.find("XYZ"[axis]); word != words.end())
                to[axis] = word->second;

        const bool arc = code >= 2;
        const Vec2 centre = arc ? Vec2(at) + Vec2(words.at('I'), words.at('J')) : Vec2(0);
        const double length =
            arc ? 2 * std::numbers::pi * glm::distance(Vec2(at), centre) : glm::distance(at, to);
        const int pieces = std::isfinite(length) ? static_cast<int>(length / kStep) + 1 : 0;
        PlainMove move{line, code == 0, {to}};
        for (int k = 0; k < pieces; ++k) {
            const double t = static_cast<double>(k) / pieces;
            move.tips.push_back(arc ? onArc(at, to, centre, code == 2, t) : at + t * (to - at));
        }
        moves.push_back(std::move(move));
        at = to;
    }
    return moves;
}

PlainStock::PlainStock(int width, int depth)
    : m_columns(width + 1), m_rows(depth + 1), m_heights(static_cast<std::size_t>(m_columns * m_rows), 0.0) {}

double PlainStock::cut(const Vec3& tip) {
    double removed = 0;
    const int x0 = std::max(0, static_cast<int>(std::ceil(tip.x - kBallRadius)));
    const int x1 = std::min(m_columns - 1, static_cast<int>(std::floor(tip.x + kBallRadius)));
    const int y0 = std::max(0, static_cast<int>(std::ceil(tip.y - kBallRadius)));
    const int y1 = std::min(m_rows - 1, static_cast<int>(std::floor(tip.y + kBallRadius)));
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const double squared = (tip.x - x) * (tip.x - x) + (tip.y - y) * (tip.y - y);
            if (squared > kBallRadius * kBallRadius)
                continue;
            double& height = m_heights[static_cast<std::size_t>(y * m_columns + x)];
            const double envelope = tip.z + kBallRadius - std::sqrt(kBallRadius * kBallRadius - squared);
            removed = std::max(removed, height - envelope);
            height = std::min(height, envelope);
        }
    }
    return removed;
}

} // namespace proveout::samples
