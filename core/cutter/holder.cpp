// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/holder.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "core/base/figures_argument.h"
#include "core/cutter/cutter_findings.h"

namespace proveout {

namespace {

/// Reads numbers and separators from the front of a text.
class SegmentText {
public:
    explicit SegmentText(std::string_view text) : m_rest(text) {}

    std::optional<double> number() {
        double value = 0;
        const char* const end = m_rest.data() + m_rest.size();
        const auto [stop, error] = std::from_chars(m_rest.data(), end, value);
        if (error != std::errc{})
            return {};
        m_rest.remove_prefix(static_cast<std::size_t>(stop - m_rest.data()));
        return value;
    }
    bool skip(char separator) {
        if (m_rest.empty() || m_rest.front() != separator)
            return false;
        m_rest.remove_prefix(1);
        return true;
    }
    [[nodiscard]] bool atEnd() const { return m_rest.empty(); }

private:
    std::string_view m_rest;
};

/// Nothing if it is not written as a segment.
std::optional<HolderSegment> segmentOf(std::string_view text) {
    SegmentText rest(text);
    const auto lower = rest.number();
    const auto upper = rest.skip('-') ? rest.number() : lower;
    const bool separated = rest.skip('x');
    const auto height = rest.number();
    if (!lower || !upper || !separated || !height || !rest.atEnd())
        return {};
    return HolderSegment{*lower / 2, *upper / 2, *height};
}

bool isSize(double size) {
    return size >= kLeastHolderSize && size <= kLargestHolderSize;
}

} // namespace

Result<std::vector<HolderSegment>> parseHolder(std::string_view text) {
    std::vector<HolderSegment> segments;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('+', at), text.size());
        const std::string_view part = text.substr(at, end - at);
        const auto segment = segmentOf(part);
        if (!segment)
            return failure(cutter_finding::kHolderUnreadable, {std::string(part), "40x30", "20-40x15"});
        if (!isSize(2 * segment->lowerRadius) || !isSize(2 * segment->upperRadius) ||
            !isSize(segment->height))
            return failure(cutter_finding::kHolderSize, {std::string(part), figures("{}", kLeastHolderSize),
                                                         figures("{}", kLargestHolderSize)});
        if (segments.size() == kMostHolderSegments)
            return failure(cutter_finding::kHolderTooLong, {std::to_string(kMostHolderSegments)});
        segments.push_back(*segment);
        at = end + 1;
    }
    return segments;
}

} // namespace proveout
