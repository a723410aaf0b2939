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

/// The most recently opened files, newest first, stored in the settings, and which of them still exist.
/// Thread: UI. An unreachable drive may take minutes to respond, so the files are checked in threads that
/// nothing waits for.
class RecentFiles final : public QObject {
    Q_OBJECT

public:
    static constexpr int kMost = 10;
    /// Whether a file exists; called on any thread, may block.
    using Probe = std::function<bool(const QString&)>;

    explicit RecentFiles(QObject* parent = nullptr);
    explicit RecentFiles(Probe probe, QObject* parent = nullptr);
    ~RecentFiles() override;

    [[nodiscard]] const QStringList& files() const { return m_files; }
    void add(const QString& file);
    void clear();

    /// Checks all files again; changed() reports new results.
    void look();
    /// Whether the file was missing at the last check. False until that is known.
    [[nodiscard]] bool isMissing(const QString& file) const;

signals:
    /// The list has changed, or whether one of its files exists.
    void changed();

private:
    struct Listener;
    void store();
    void answered(const QString& file, bool there);

    Probe m_probe;
    QStringList m_files;
    std::map<QString, bool> m_there;
    QStringList m_asked; ///< being checked
    std::shared_ptr<Listener> m_listener;
    UiQueue m_answers;
};

} // namespace proveout
