// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace proveout::bench {

/// Prints what the real window takes from its start to the picture of the end of each workload, beside the
/// command line and the kernels, and the gaps of its event loop meanwhile (by window_run). Prints that the
/// rows are left out if there is no display. False if a run fails, or if the window computes for more than
/// 250 ms in 1 % of the gaps.
[[nodiscard]] bool printWindow(int runs);

} // namespace proveout::bench
