// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/entered_sizes.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace proveout {

namespace {

/// `SHAPE:key=value,…`, split into its parts.
struct SpecText {
    std::string shape;
    std::map<std::string, std::string> values;

    explicit SpecText(std::string_view spec) {
        std::size_t end = std::min(spec.find(':'), spec.size());
        shape = spec.substr(0, end);
        while (end < spec.size()) {
            spec.remove_prefix(end + 1);
            end = std::min(spec.find(','), spec.size());
            const std::string_view pair = spec.substr(0, end);
            if (const std::size_t equals = pair.find('='); equals != std::string_view::npos)
                values[std::string(pair.substr(0, equals))] = pair.substr(equals + 1);
        }
    }

    /// Adopts the value that `other` has; where it has none, the default applies.
    void adopt(const std::string& key, const SpecText& other) {
        if (const auto found = other.values.find(key); found != other.values.end())
            values[key] = found->second;
        else
            values.erase(key);
    }

    [[nodiscard]] std::string text() const {
        std::string out = shape;
        for (const auto& [key, value] : values)
            out.append(1, out.size() == shape.size() ? ':' : ',').append(key).append("=").append(value);
        return out;
    }
};

bool has(const std::vector<std::string>& keys, std::string_view key) {
    return std::ranges::find(keys, key) != keys.end();
}

/// What the comment states and the user has not entered, put into the user's cutter. If the user has chosen
/// another shape, its keys differ, and only the keys that all shapes have come from the comment.
SpecText combined(const SpecText& stated, const SpecText& present, const std::vector<std::string>& entered) {
    if (!has(entered, "shape")) {
        SpecText out = stated;
        for (const std::string& key : entered)
            out.adopt(key, present);
        return out;
    }
    SpecText out = present;
    if (present.values.contains("d")) // a form cutter has no diameter
        out.adopt("d", stated);
    if (!has(entered, "l"))
        out.adopt("l", stated);
    return out;
}

} // namespace

SourcedCutter withEntered(const SourcedCutter& stated, const SourcedCutter& present) {
    const std::vector<std::string>& entered = present.origin.entered;
    if (entered.empty())
        return stated;
    auto cutter = parseCutter(
        combined(SpecText(stated.cutter.spec()), SpecText(present.cutter.spec()), entered).text());
    if (!cutter)
        return stated;
    SourcedCutter out{std::move(*cutter), stated.origin};
    if (has(entered, "shape"))
        out.origin.defaults = present.origin.defaults;
    std::erase_if(out.origin.defaults, [&](const std::string& key) { return has(entered, key); });
    out.origin.entered = entered;
    return out;
}

} // namespace proveout
