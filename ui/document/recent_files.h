// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>

#include <QObject>
#include <QString>
#include <QStringList>

#include "ui/work/ui_queue.h"

namespace proveout {

/// The files opened last, newest first, kept in the settings; and which of them are still there. Thread: UI.
/// A drive that is away may take minutes to answer: files are looked for in threads that nobody waits for.
class RecentFiles final : public QObject {
    Q_OBJECT

public:
    static constexpr int kMost = 10;
    /// Whether a file is there; called from any thread, may block.
    using Probe = std::function<bool(const QString&)>;

    explicit RecentFiles(QObject* parent = nullptr);
    explicit RecentFiles(Probe probe, QObject* parent = nullptr);
    ~RecentFiles() override;

    [[nodiscard]] const QStringList& files() const { return m_files; }
    void add(const QString& file);
    void clear();

    /// Looks for all files anew; changed() tells of news.
    void look();
    /// Whether the file was not there when it was looked for last. False until that is known.
    [[nodiscard]] bool isMissing(const QString& file) const;

signals:
    /// Another list, or news of one of its files.
    void changed();

private:
    struct Listener;
    void store();
    void answered(const QString& file, bool there);

    Probe m_probe;
    QStringList m_files;
    std::map<QString, bool> m_there;
    QStringList m_asked; ///< no answer yet
    std::shared_ptr<Listener> m_listener;
    UiQueue m_answers;
};

} // namespace proveout
