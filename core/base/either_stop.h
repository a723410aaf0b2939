// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <utility>

namespace proveout {

/// A request to stop that follows two others: work that both a user and a limit may stop. While it exists,
/// any thread may make either request.
class EitherStop {
public:
    EitherStop(std::stop_token one, std::stop_token other)
        : m_one(std::move(one), Follow{m_either}), m_other(std::move(other), Follow{m_either}) {}
    EitherStop(const EitherStop&) = delete;
    EitherStop& operator=(const EitherStop&) = delete;

    [[nodiscard]] std::stop_token token() const { return m_either.get_token(); }

private:
    struct Follow {
        std::stop_source either;
        void operator()() { either.request_stop(); }
    };

    std::stop_source m_either; ///< before the callbacks, which may run when they are constructed
    std::stop_callback<Follow> m_one;
    std::stop_callback<Follow> m_other;
};

} // namespace proveout
