// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/document_reader.h"

#include <exception>
#include <memory>
#include <new>
#include <utility>

#include "core/verification/findings/window_findings.h"
#include "ui/document/job_permissions.h"

namespace proveout {

namespace {

constexpr int kUntilReportedMs = 150; ///< reads that end within this time report no progress

template<typename T>
Result<T> readOrReport(const std::function<Result<T>(const WorkContext&)>& read, const WorkContext& context) {
    try {
        return read(context);
    } catch (const std::bad_alloc&) {
        return failure(window_finding::kReadingOutOfMemory);
    } catch (const std::exception& exception) {
        return failure(window_finding::kReadingFailed, {exception.what()});
    }
}

} // namespace

DocumentReader::DocumentReader(QObject* parent) : QObject(parent) {
    m_untilReported.setSingleShot(true);
    m_untilReported.setInterval(kUntilReportedMs);
    connect(&m_untilReported, &QTimer::timeout, this, [this] {
        if (!m_progress)
            m_progress = 0;
        emit progressChanged();
    });
}

void DocumentReader::open(const QString& file, Done<JobDocument> done) {
    start<JobDocument>([file, allowed = allowedOutside(file)](
                           const WorkContext& context) { return JobDocument::open(file, context, allowed); },
                       std::move(done));
}

void DocumentReader::restore(const KeptWork& kept, Done<JobDocument> done) {
    start<JobDocument>([kept](const WorkContext& context) { return JobDocument::restore(kept, context); },
                       std::move(done));
}

void DocumentReader::readText(const std::filesystem::path& file, Done<Document> done) {
    start<Document>([file](const WorkContext& context) { return loadClosedDocument(file, context); },
                    std::move(done));
}

template<typename T>
void DocumentReader::start(std::function<Result<T>(const WorkContext&)> read, Done<T> done) {
    cancel();
    m_reading = true;
    m_untilReported.start();
    m_task.start([this, read = std::move(read), done = std::move(done)](const NewestTask::Reply& reply) {
        WorkContext context;
        context.stop = reply.stop;
        context.progress = [this, &reply](double share) { reply.post([this, share] { progressed(share); }); };
        // Shared, because a posted function must be copyable, while the document is moved and not copied.
        const auto result = std::make_shared<Result<T>>(readOrReport(read, context));
        reply.post([this, result, done] {
            end();
            done(std::move(*result));
        });
    });
}

void DocumentReader::cancel() {
    m_task.cancel();
    end();
}

void DocumentReader::progressed(double done) {
    m_progress = done;
    emit progressChanged();
}

void DocumentReader::end() {
    m_untilReported.stop();
    m_reading = false;
    if (std::exchange(m_progress, std::nullopt))
        emit progressChanged();
}

} // namespace proveout
