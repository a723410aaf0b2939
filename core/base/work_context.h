// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stop_token>

namespace proveout {

/// What a caller passes to a long job: a request to stop, and a callback for its progress. Value type; the
/// default one never stops and reports nothing. `progress` is called on the thread that was given the
/// context, with values that rise from 0 to 1. A job that sees `stopped()` leaves its outputs in a valid
/// state and returns early.
struct WorkContext {
    std::stop_token stop;
    std::function<void(double)> progress;

    [[nodiscard]] bool stopped() const { return stop.stop_requested(); }
    void report(double done) const {
        if (progress)
            progress(done);
    }
    /// The context of a step that is the part [from, to] of the whole work.
    [[nodiscard]] WorkContext part(double from, double to) const {
        if (!progress)
            return {stop, {}};
        return {stop, [whole = progress, from, to](double done) { whole(from + (to - from) * done); }};
    }
    /// The context of a step that is too short to report its progress.
    [[nodiscard]] WorkContext quiet() const { return {stop, {}}; }
};

} // namespace proveout
