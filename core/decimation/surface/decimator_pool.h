// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/decimation/regions/region_decimator.h"

namespace proveout {

/// Decimators that are kept for reuse, so that their storage lives as long as the surface (paper §4.1). Any
/// thread may borrow one; the pool never holds more than were in use at the same time.
class DecimatorPool {
public:
    struct Worker {
        std::unique_ptr<RegionDecimator> decimator;
        std::vector<float> heights; ///< samples of the current region
    };

    /// A worker borrowed until the end of the scope.
    class Loan {
    public:
        Loan(DecimatorPool& pool, const DecimationMethodRow& method)
            : m_pool(pool), m_worker(pool.acquire(method)) {}
        ~Loan() { m_pool.giveBack(std::move(m_worker)); }
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;
        Worker& operator*() { return *m_worker; }

    private:
        DecimatorPool& m_pool;
        std::unique_ptr<Worker> m_worker;
    };

    /// Counts the triangles that the workers made.
    void noteFaces(std::size_t count) { m_faces += count; }
    [[nodiscard]] std::size_t facesMade() const { return m_faces; }

private:
    std::unique_ptr<Worker> acquire(const DecimationMethodRow& method) {
        {
            const std::lock_guard lock(m_mutex);
            if (!m_idle.empty()) {
                std::unique_ptr<Worker> worker = std::move(m_idle.back());
                m_idle.pop_back();
                return worker;
            }
        }
        return std::make_unique<Worker>(Worker{method.create(), {}});
    }
    void giveBack(std::unique_ptr<Worker> worker) {
        const std::lock_guard lock(m_mutex);
        m_idle.push_back(std::move(worker));
    }

    std::atomic<std::size_t> m_faces = 0;
    std::mutex m_mutex;
    std::vector<std::unique_ptr<Worker>> m_idle;
};

} // namespace proveout
