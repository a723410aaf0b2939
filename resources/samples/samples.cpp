// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/samples/samples.h"

#include "resources/samples/core_insert.h"
#include "resources/samples/job_text.h"
#include "resources/samples/mouse_case.h"

namespace proveout::samples {

std::vector<SampleFile> sampleFiles() {
    return {
        {"core-insert.nc", coreInsertProgram()},
        {"core-insert.proveout", jobText("core-insert.nc", 140, 140, 50)},
        {"mouse-case.nc", mouseCaseProgram()},
        {"mouse-case.proveout", jobText("mouse-case.nc", 140, 100, 50)},
    };
}

} // namespace proveout::samples
