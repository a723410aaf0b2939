// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cgal/sample_maps.h"

#include <filesystem>
#include <gtest/gtest.h>

#include "core/cutting/cut/cutting.h"
#include "core/formats/job_file.h"
#include "core/nc/run/interpreter.h"

namespace proveout::test {

ZMapSnapshot sampleMap(const std::string& name) {
    const auto folder = std::filesystem::path(PROVEOUT_SOURCE_DIR) / "resources" / "samples";
    const auto job = readJob(folder / (name + ".proveout"));
    EXPECT_TRUE(job) << oneLine(job.error().front());
    if (!job)
        return {};
    const auto text = NcText::load(job->program);
    EXPECT_TRUE(text) << oneLine(text.error().front());
    if (!text)
        return {};
    const auto program = interpret(*text);
    ZMap zmap(job->setup.stock, makeGrid(job->setup.stock, job->setup.spacing).value());
    for (std::size_t m = 0; m < program->motionCount(); ++m) {
        const Motion motion = program->motion(m);
        if (const Cutter* cutter = job->setup.tools.find(motion.tool))
            static_cast<void>(cut(zmap, *cutter, motion));
    }
    return zmap.snapshot();
}

} // namespace proveout::test
