// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/samples/job_text.h"

#include <fmt/format.h>

namespace proveout::samples {

std::string jobText(std::string_view program, int width, int depth, int height) {
    return fmt::format(R"({{
  "proveout": 2,
  "program": "{}",
  "stock": {{"minX": 0, "minY": 0, "topZ": 0, "width": {}, "depth": {}, "height": {}}},
  "grid": 1.0,
  "tools": {{"1": "ball:d=11,l=50"}},
  "decimation": {{
    "method": "certified",
    "region": 16,
    "period": 5,
    "allowance": 0.05,
    "level": "surface"
  }}
}}
)",
                       program, width, depth, height);
}

} // namespace proveout::samples
