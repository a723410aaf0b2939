// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/part_hub.h"

#include <exception>
#include <new>
#include <utility>

#include "core/base/figures_argument.h"
#include "core/base/finding_row.h"
#include "core/base/memory.h"
#include "core/base/parallel.h"
#include "core/base/thread_priority.h"
#include "core/part/part_findings.h"
#include "core/verification/part/comparison_findings.h"
#include "ui/session/job_hub.h"
#include "ui/session/simulation_hub.h"

namespace proveout {

namespace {

constexpr int kComparisonSteps = 50;
constexpr std::uint64_t kMemoryShare = 4;

/// Nobody waits for the memory of a part or a map that is too large: then there is none.
template<class Work>
auto orNothing(const Work& work) -> decltype(work()) {
    decltype(work()) result{};
    try {
        onThisThread([&] { result = work(); });
    } catch (const std::bad_alloc&) {
        return {};
    }
    return result;
}

} // namespace

PartHub::PartHub(const JobHub& job, const SimulationHub& simulation) : m_job(job), m_simulation(simulation) {
    connect(&job, &JobHub::partChanged, this, &PartHub::adopt);
    connect(&simulation, &SimulationHub::taken, this, &PartHub::compare);
}

std::uint64_t PartHub::memory() const {
    return m_memoryLimit.value_or(memoryLimitBytes() / kMemoryShare);
}

void PartHub::setMemoryLimit(std::uint64_t bytes) {
    m_memoryLimit = bytes;
    reread();
}

void PartHub::reread() {
    m_read.reset();
    adopt();
}

void PartHub::setOn(const QObject& user, bool on) {
    if (on == m_users.contains(&user))
        return;
    if (on) {
        m_users.insert(&user);
        connect(&user, &QObject::destroyed, this, &PartHub::leave);
        return compare();
    }
    disconnect(&user, &QObject::destroyed, this, &PartHub::leave);
    leave(&user);
    emit changed();
}

/// Emits nothing, because a user that is being destroyed may still be connected.
void PartHub::leave(const QObject* user) {
    m_users.erase(user);
    if (m_users.empty())
        clear();
}

/// The file is read again unless only the tolerance has changed.
void PartHub::adopt() {
    std::optional<PartSpec> wanted = m_job.part();
    if (wanted)
        wanted->tolerance = {};
    if (wanted != m_read) {
        m_read = std::move(wanted);
        return read();
    }
    compare();
}

void PartHub::read() {
    m_reading.cancel();
    clear();
    m_contents = {};
    m_isReading = m_read.has_value();
    if (m_read)
        m_reading.start([this, spec = *m_read, memory = memory()](const NewestTask::Reply& reply) {
            lowerThreadPriority();
            PartContents contents = orNothing([&] { return readPart(spec, memory); });
            reply.post([this, contents = std::move(contents)] {
                m_contents = contents;
                m_isReading = false;
                emit partChanged();
                compare();
            });
        });
    emit partChanged();
    emit changed();
}

void PartHub::clear() {
    m_comparing.cancel();
    m_comparison.reset();
    m_compared.reset();
    m_placement.clear();
    m_progress.reset();
}

bool PartHub::fits(const Frame& frame) {
    const StockBox& stock = frame.setup->stock;
    m_placement = placementFindings(*m_contents.part, stock, m_job.part()->tolerance);
    if (isMisplaced(*m_contents.part, stock))
        return false;
    const double needed = comparisonBytes(frame.zmap.grid());
    if (needed <= static_cast<double>(memory()))
        return true;
    m_placement.push_back(
        diagnosticOf(part_finding::kTooLarge, {figures("{}", readableBytes(needed)),
                                               figures("{}", readableBytes(static_cast<double>(memory())))}));
    return false;
}

void PartHub::compare() {
    if (m_users.empty() || !m_job.part() || m_contents.part == nullptr)
        return;
    const FramePtr& frame = m_simulation.frame();
    if (frame == nullptr || !frame->atRest)
        return;
    const PartTolerance tolerance = m_job.part()->tolerance;
    if (m_compared == frame && m_tolerance == tolerance)
        return;
    if (m_compared && m_compared->setup != frame->setup)
        clear();
    m_compared = frame;
    m_tolerance = tolerance;
    if (!fits(*frame)) {
        m_comparing.cancel();
        m_comparison.reset();
        m_progress.reset();
        emit changed();
        return;
    }
    m_progress = 0;
    m_comparing.start([this, frame, part = m_contents.part, tolerance](const NewestTask::Reply& reply) {
        lowerThreadPriority();
        const auto report = [this, &reply, last = 0](double done) mutable {
            const int step = static_cast<int>(done * kComparisonSteps);
            if (std::exchange(last, step) != step)
                reply.post([this, done] {
                    m_progress = done;
                    emit changed();
                });
        };
        auto comparison = orNothing([&] {
            return comparePart(*frame, part, tolerance, {reply.stop, report});
        });
        if (!reply.stop.stop_requested())
            reply.post([this, comparison = std::move(comparison)] {
                m_comparison = comparison;
                m_progress.reset();
                emit changed();
            });
    });
    emit changed();
}

} // namespace proveout
