// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stop_token>

namespace proveout {

/// What a long job is given by its caller: the wish to stop, and a place to tell how far it is.
/// Value type; the default one never stops and tells nobody. `progress` is called from the thread that works,
/// with values that rise from 0 to 1. A job that sees `stopped()` leaves its outputs in a valid state and
/// returns early.
struct WorkContext {
    std::stop_token stop;
    std::function<void(double)> progress;

    [[nodiscard]] bool stopped() const { return stop.stop_requested(); }
    void tell(double done) const {
        if (progress)
            progress(done);
    }
    /// For a step of a job: the same wish to stop, and 0 to 1 of the step told as `from` to `to` of the
    /// whole.
    [[nodiscard]] WorkContext part(double from, double to) const {
        return {stop, [whole = progress, from, to](double done) {
                    if (whole)
                        whole(from + (to - from) * done);
                }};
    }
};

} // namespace proveout
