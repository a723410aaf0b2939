// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/document_writer.h"

#include <system_error>
#include <utility>

#include "ui/document/file_paths.h"
#include "ui/document/new_file_beside.h"

namespace proveout {

namespace {

constexpr int kUntilSlowMs = 150;

/// Whether writing or comparing it may take longer than a frame.
bool isLong(const JobDocument& document) {
    constexpr std::size_t kQuickly = 1'000'000; // bytes
    return document.text().text.size() > kQuickly;
}

DocumentWriter::Written written(const Result<void>& result, const JobDocument& before,
                                const JobDocument& after, std::optional<FilePart> part) {
    if (part)
        return {result, result && part == FilePart::text, result && part == FilePart::job};
    return {result, before.text().modified && !after.text().modified,
            before.jobModified() && !after.jobModified()};
}

} // namespace

DocumentWriter::DocumentWriter(QObject* parent) : QObject(parent) {
    m_untilSlow.setSingleShot(true);
    m_untilSlow.setInterval(kUntilSlowMs);
    connect(&m_untilSlow, &QTimer::timeout, this, [this] { emit progressed(0); });
}

DocumentWriter::~DocumentWriter() = default;

void DocumentWriter::save(JobDocument& document, const Save& save, std::optional<FilePart> part,
                          const std::function<void(const Written&)>& done) {
    if (m_running)
        return;
    const JobDocument before = document;
    if (!isLong(before)) {
        const Result<void> result = save(document);
        return done(written(result, before, document, part));
    }
    JobDocument copy = before;
    Result<void> result;
    m_open = true;
    run([&] { result = save(copy); },
        [&] {
            Written all = written(result, before, copy, part);
            all.open = m_open;
            if (m_open)
                document.takeFiles(copy);
            done(all);
        },
        QEventLoop::AllEvents);
}

std::optional<DiskConflict> DocumentWriter::conflict(const JobDocument& document, FilePart part) {
    if (!isLong(document) || m_running)
        return document.conflict(part);
    const JobDocument copy = document;
    std::optional<DiskConflict> found;
    run([&] { found = copy.conflict(part); }, [] {}, QEventLoop::ExcludeUserInputEvents);
    return found;
}

Result<void> DocumentWriter::saveBeside(JobDocument& document, FilePart part) {
    const bool text = part == FilePart::text;
    const Result<std::filesystem::path> beside =
        newFileBeside(text ? document.text().path : toPath(document.jobFile()));
    if (!beside)
        return tl::unexpected(beside.error());
    const QString file = toQString(*beside);
    Result<void> result = text ? document.saveTextAs(file) : document.saveJobAs(file);
    if (!result) {
        std::error_code ignored; // nothing is lost, because the file is empty and new
        std::filesystem::remove(*beside, ignored);
    }
    return result;
}

void DocumentWriter::run(const std::function<void()>& work, const std::function<void()>& done,
                         QEventLoop::ProcessEventsFlags meanwhile) {
    m_running = true;
    m_done = done;
    m_untilSlow.start();
    emit started();
    m_thread = std::jthread([this, &work] {
        try {
            work();
        } catch (...) {
            m_exception = std::current_exception();
        }
        m_replies.post([this] { end(); });
    });
    QEventLoop loop;
    connect(this, &DocumentWriter::ended, &loop, &QEventLoop::quit);
    loop.exec(meanwhile);
    end(); // the loop ends early if the application does
    if (m_exception)
        std::rethrow_exception(std::exchange(m_exception, nullptr));
}

void DocumentWriter::pause(FileWatch& watch) {
    connect(this, &DocumentWriter::started, &watch, [&watch] { watch.setPaused(true); });
    connect(this, &DocumentWriter::ended, &watch, [&watch] { watch.setPaused(false); });
}

void DocumentWriter::wait() {
    if (!m_running)
        return;
    QEventLoop loop;
    connect(this, &DocumentWriter::ended, &loop, &QEventLoop::quit);
    loop.exec(QEventLoop::ExcludeUserInputEvents);
    end();
}

void DocumentWriter::end() {
    if (!m_running)
        return;
    m_thread.join();
    m_running = false;
    m_untilSlow.stop();
    if (const auto done = std::exchange(m_done, {}); !m_exception)
        done();
    emit progressed({});
    emit ended();
}

} // namespace proveout
