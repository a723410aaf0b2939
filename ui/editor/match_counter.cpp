// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/match_counter.h"

#include <algorithm>
#include <utility>

namespace proveout {

namespace {
constexpr std::size_t kSlice = 1 << 20; // bytes, a few milliseconds
constexpr int kReportMs = 150;          // each report repaints the window
} // namespace

MatchCounter::MatchCounter(Text text, QObject* parent) : QObject(parent), m_text(std::move(text)) {
    connect(&m_timer, &QTimer::timeout, this, &MatchCounter::countPart);
}

void MatchCounter::count(const TextPattern& pattern) {
    m_pattern = pattern;
    m_from = 0;
    m_matches.clear();
    m_more = false;
    m_sinceReported.start();
    m_timer.start();
}

void MatchCounter::countPart() {
    const std::string_view text = m_text();
    const std::size_t stop = std::min(text.size(), m_from + kSlice);
    while (const auto match = findForward(text, m_pattern, m_from, stop)) {
        m_more = m_matches.size() == kMost;
        if (m_more)
            break;
        m_matches.push_back(*match);
        m_from = *match + m_pattern.bytes.size();
    }
    m_from = std::max(m_from, stop);
    if (m_more || m_from >= text.size() || m_pattern.bytes.empty())
        m_timer.stop();
    else if (m_sinceReported.elapsed() < kReportMs)
        return;
    m_sinceReported.start();
    emit progressed();
}

} // namespace proveout
