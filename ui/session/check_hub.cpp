// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/check_hub.h"

#include <exception>
#include <new>
#include <utility>

#include "core/base/memory.h"
#include "core/base/parallel.h"
#include "core/base/thread_priority.h"
#include "core/verification/check/check.h"
#include "core/verification/findings/check_findings.h"
#include "ui/session/document_hub.h"
#include "ui/session/job_hub.h"
#include "ui/session/part_hub.h"
#include "ui/session/program_hub.h"

namespace proveout {

namespace {

constexpr int kPauseMs = 400;
constexpr int kProgressSteps = 100;
constexpr std::size_t kCheckpointBytes = std::size_t{64} << 20;

using CheckResult = Result<std::shared_ptr<const CheckReport>>;

CheckResult checkOnOneThread(Checker& checker, const CheckSubject& subject, const CheckRules& rules,
                             std::uint64_t memoryBytes, const WorkContext& context) {
    CheckResult result;
    try {
        onThisThread([&] { result = checker.check(subject, rules, memoryBytes, context); });
    } catch (const std::bad_alloc&) {
        result = failure(check_finding::kCheckOutOfMemory);
    } catch (const std::exception& exception) {
        result = failure(check_finding::kCheckFailed, {exception.what()});
    }
    return result;
}

} // namespace

CheckHub::CheckHub(const DocumentHub& document, const ProgramHub& program, const JobHub& job,
                   const PartHub& part)
    : m_document(document), m_program(program), m_job(job), m_part(part),
      m_checker(std::make_shared<Checker>(kCheckpointBytes)) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, &CheckHub::begin);
    connect(&program, &ProgramHub::outdated, this, &CheckHub::restart);
    connect(&program, &ProgramHub::changed, this, &CheckHub::restart);
    connect(&program, &ProgramHub::failed, this,
            [this](const Diagnostics& errors) { finish(tl::unexpected(errors)); });
    connect(&document, &DocumentHub::textReplaced, this, [this] {
        restart();
        m_before.reset();
    });
    connect(&job, &JobHub::setupChanged, this, &CheckHub::restart);
    connect(&job, &JobHub::machineChanged, this, &CheckHub::restart);
    connect(&job, &JobHub::partChanged, this, &CheckHub::restart);
    connect(&part, &PartHub::partChanged, this, &CheckHub::restart);
    connect(&job, &JobHub::checkChanged, this, &CheckHub::adoptRules);
}

std::optional<CheckChange> CheckHub::change() const {
    return m_report && m_before ? std::optional(changeBetween(*m_before, *m_report)) : std::nullopt;
}

void CheckHub::setAccepted(std::set<std::string> accepted) {
    m_accepted = std::move(accepted);
    answer();
}

/// Other limits need another check; what somebody answers for does not.
void CheckHub::adoptRules() {
    const CheckRules& rules = m_job.check();
    const bool sameRules = rules.limits == m_rules.limits && rules.off == m_rules.off &&
                           rules.limitsOfTools == m_rules.limitsOfTools;
    if (sameRules)
        answer();
    else
        restart();
}

void CheckHub::answer() {
    if (m_report)
        m_report =
            std::make_shared<const CheckReport>(m_report->answered(allAccepted(), m_job.check().waivers));
    emit changed();
}

IdsWithReasons CheckHub::allAccepted() const {
    IdsWithReasons accepted = m_job.check().accepted;
    for (const std::string& id : m_accepted)
        accepted.insert({id, {}}); // a reason of the job stays
    return accepted;
}

void CheckHub::setMemoryLimit(std::uint64_t bytes) {
    m_memoryLimit = bytes;
    restart();
}

void CheckHub::setOn(bool on) {
    m_on = on;
    restart();
}

/// Cancels the check, and begins again once there is a program that has not changed for a moment. While the
/// user types, nothing more changes than at the first key.
void CheckHub::restart() {
    m_task.cancel();
    m_pause.stop();
    const bool waits = m_on && m_document.isOpen();
    const bool isNews = m_report || !m_refusal.empty() || waits != (m_progress == 0.0);
    if (m_report)
        m_before = std::move(m_report);
    m_report.reset();
    m_refusal.clear();
    m_progress = waits ? std::optional(0.0) : std::nullopt;
    if (waits && m_program.current() && m_program.isUpToDate() && !m_program.isReading() &&
        !m_part.isReading())
        m_pause.start();
    if (isNews)
        emit changed();
}

void CheckHub::begin() {
    if (m_program.isForeign())
        return finish(tl::unexpected(m_program.current()->diagnostics()));
    std::optional<PartToCompare> part;
    if (m_job.part())
        part = {.of = m_part.contents(), .tolerance = m_job.part()->tolerance};
    const CheckSubject subject{.program = m_program.current(),
                               .setup = m_document.job().setup(),
                               .machine = m_job.machine(),
                               .stockFitted = m_document.job().stockFitted(),
                               .proposals = m_program.proposals(),
                               .part = std::move(part)};
    m_rules = m_job.check();
    const std::uint64_t memory = m_memoryLimit.value_or(memoryLimitBytes() / 2);
    m_task.start(
        [this, checker = m_checker, subject, rules = m_rules, memory](const NewestTask::Reply& reply) {
            lowerThreadPriority();
            const auto report = [this, &reply, last = 0](double done) mutable {
                const int step = static_cast<int>(done * kProgressSteps);
                if (std::exchange(last, step) == step)
                    return;
                reply.post([this, done] {
                    m_progress = done;
                    emit progressed();
                });
            };
            auto result = checkOnOneThread(*checker, subject, rules, memory, {reply.stop, report});
            if (!reply.stop.stop_requested())
                reply.post([this, result = std::move(result)] { finish(result); });
        });
}

void CheckHub::finish(const CheckResult& result) {
    m_progress.reset();
    if (result)
        m_report =
            std::make_shared<const CheckReport>((*result)->answered(allAccepted(), m_job.check().waivers));
    else
        m_refusal = result.error();
    emit changed();
}

} // namespace proveout
