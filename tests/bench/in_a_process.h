// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/wait.h>
#include <type_traits>
#include <unistd.h>

namespace proveout::bench {

/// What `make` returns, in a process of its own, whose memory is its own as well; the value of a default if
/// it fails. The caller must not have started threads.
template<class Make>
auto inAProcess(const Make& make) {
    using Value = decltype(make());
    static_assert(std::is_trivially_copyable_v<Value>);
    Value value{};
    int ends[2];
    if (pipe(ends) != 0)
        return value;
    const pid_t child = fork();
    if (child == 0) {
        const Value made = make();
        const bool sent = write(ends[1], &made, sizeof made) == static_cast<ssize_t>(sizeof made);
        _exit(sent ? 0 : 1);
    }
    close(ends[1]);
    if (read(ends[0], &value, sizeof value) != static_cast<ssize_t>(sizeof value))
        value = {};
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return value;
}

} // namespace proveout::bench
