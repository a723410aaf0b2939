// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep line moves up over all pieces: two pieces that cross are neighbours on it just before they do.
#include "core/zmap/outline_crossing.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

namespace proveout {

namespace {

/// Pieces that are nearer to each other than this, in mm, touch.
constexpr double kTouching = 1e-3;

double rightOf(const OutlinePiece& a, const OutlinePiece& b, double y) {
    return a.crossing(y) - b.crossing(y);
}

/// Looks below and above the height where two pieces change sides. Arcs may do so twice, so the middle is
/// checked as well.
std::optional<Vec2> crossingOfTwo(const OutlinePiece& a, const OutlinePiece& b) {
    double below = std::max(a.low.y, b.low.y);
    double above = std::min(a.high.y, b.high.y);
    double side = 0;
    for (const double y : {below, (below + above) / 2, above}) {
        const double now = rightOf(a, b, y);
        if (std::abs(now) <= kTouching)
            continue;
        if (side * now < 0) {
            above = y;
            constexpr int kHalvings = 40;
            for (int k = 0; k < kHalvings; ++k) {
                const double middle = (below + above) / 2;
                (side * rightOf(a, b, middle) > 0 ? below : above) = middle;
            }
            return Vec2(a.crossing(below), below);
        }
        side = now;
        below = y;
    }
    return std::nullopt;
}

class LevelLine {
public:
    explicit LevelLine(std::span<const OutlinePiece> pieces)
        : m_pieces(pieces), m_crossed(Order{this}), m_places(pieces.size(), m_crossed.end()) {}

    std::optional<Vec2> goUp() {
        for (const Event& event : events()) {
            m_y = event.y;
            const auto found = event.kind == Event::leaves   ? leave(event.piece)
                               : event.kind == Event::enters ? enter(event.piece)
                                                             : passOver(m_pieces[event.piece]);
            if (found)
                return found;
        }
        return std::nullopt;
    }

private:
    struct Event {
        enum Kind { leaves, level, enters };
        double y;
        Kind kind;
        std::size_t piece;
    };
    struct Abscissa {
        double x;
    };
    /// From left to right; pieces that begin at the same place are compared by their further course.
    struct Order {
        using is_transparent = void;
        const LevelLine* line;
        bool operator()(std::size_t a, const Abscissa& place) const {
            return line->m_pieces[a].crossing(line->m_y) < place.x;
        }
        bool operator()(std::size_t a, std::size_t b) const {
            const OutlinePiece& one = line->m_pieces[a];
            const OutlinePiece& other = line->m_pieces[b];
            const double top = std::min(one.high.y, other.high.y);
            const double y =
                std::clamp(line->m_y, std::max(one.low.y, other.low.y), std::max(top, line->m_y));
            const double here = rightOf(one, other, std::min(y, top));
            const double side =
                std::abs(here) > kTouching ? here : rightOf(one, other, (std::min(y, top) + top) / 2);
            return side != 0 ? side < 0 : a < b;
        }
    };
    using Crossed = std::set<std::size_t, Order>;

    [[nodiscard]] std::vector<Event> events() const {
        std::vector<Event> events;
        for (std::size_t k = 0; k < m_pieces.size(); ++k) {
            const OutlinePiece& piece = m_pieces[k];
            if (piece.low.y < piece.high.y) {
                events.push_back({piece.low.y, Event::enters, k});
                events.push_back({piece.high.y, Event::leaves, k});
            } else {
                events.push_back({piece.low.y, Event::level, k});
            }
        }
        std::ranges::sort(events, [](const Event& a, const Event& b) {
            return a.y != b.y ? a.y < b.y : a.kind != b.kind ? a.kind < b.kind : a.piece < b.piece;
        });
        return events;
    }

    std::optional<Vec2> enter(std::size_t piece) {
        const auto at = m_crossed.insert(piece).first;
        m_places[piece] = at;
        const auto next = std::next(at);
        if (next != m_crossed.end()) {
            if (const auto found = crossingOfTwo(m_pieces[piece], m_pieces[*next]))
                return found;
        }
        return at == m_crossed.begin() ? std::nullopt
                                       : crossingOfTwo(m_pieces[*std::prev(at)], m_pieces[piece]);
    }

    std::optional<Vec2> leave(std::size_t piece) {
        const auto next = m_crossed.erase(m_places[piece]);
        if (next == m_crossed.begin() || next == m_crossed.end())
            return std::nullopt;
        return crossingOfTwo(m_pieces[*std::prev(next)], m_pieces[*next]);
    }

    /// Passes over a horizontal side: a piece that goes through it continues both below and above.
    std::optional<Vec2> passOver(const OutlinePiece& side) {
        const double from = std::min(side.low.x, side.high.x) + kTouching;
        const double to = std::max(side.low.x, side.high.x) - kTouching;
        for (auto at = m_crossed.lower_bound(Abscissa{from}); at != m_crossed.end(); ++at) {
            const OutlinePiece& piece = m_pieces[*at];
            const double x = piece.crossing(m_y);
            if (x >= to)
                break;
            if (piece.low.y < m_y - kTouching && piece.high.y > m_y + kTouching)
                return Vec2(x, m_y);
        }
        return std::nullopt;
    }

    std::span<const OutlinePiece> m_pieces;
    double m_y = 0;
    Crossed m_crossed;
    std::vector<Crossed::iterator> m_places; ///< by piece: its position in m_crossed
};

} // namespace

std::optional<Vec2> crossingOf(std::span<const OutlinePiece> pieces) {
    return LevelLine(pieces).goUp();
}

} // namespace proveout
