// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/samples/job_text.h"

#include <fmt/format.h>

namespace proveout::samples {

std::string jobText(std::string_view program, int width, int depth, int height) {
    return fmt::format(R"({{
  "proveout": 1,
  "program": "{}",
  "stock": {{"corner": [0, 0, 0], "width": {}, "depth": {}, "height": {}}},
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
