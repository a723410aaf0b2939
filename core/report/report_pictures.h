// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/work_context.h"
#include "core/report/report_page.h"
#include "core/verification/part/part_comparison.h"

namespace proveout {

/// The pictures of a stock, and of its comparison with a part if there is one (null: none). The part in 3D is
/// left out if the stock has more points than such a page should hold. Throws std::bad_alloc.
[[nodiscard]] ReportPictures reportPictures(const ZMapSnapshot& stock, const PartComparison* comparison,
                                            const WorkContext& context = {});

} // namespace proveout
