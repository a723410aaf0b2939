// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/write_signals.h"

#include <cerrno>
#include <csignal>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/base/atomic_file.h"
#include "tests/core/file_size_limit.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

TEST(WriteSignals, AFailedWriteDoesNotEndTheProcess) {
    const TemporaryFolder folder;
    EXPECT_EXIT(
        {
            const FileSizeLimit limit(1000);
            std::signal(SIGXFSZ, SIG_DFL);
            std::signal(SIGPIPE, SIG_DFL);
            reportFailedWrites();
            const bool refused = !writeFile(folder / "a", std::string(2000, 'x'));
            int pipe[2];
            const bool made = ::pipe(pipe) == 0 && ::close(pipe[0]) == 0;
            const bool broken = ::write(pipe[1], "x", 1) < 0 && errno == EPIPE;
            std::_Exit(refused && made && broken ? 0 : 1);
        },
        testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace proveout
