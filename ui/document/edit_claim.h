// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QString>
#include <QTimer>

class QLockFile;

namespace proveout {

/// The process whose window has unsaved changes of a file. Value type.
struct EditHolder {
    qint64 process = 0;
    QString computer;

    friend bool operator==(const EditHolder&, const EditHolder&) = default;
};

/// Announces to the user's other windows that this one has unsaved changes of a file, and notices when
/// another window has some. A claim is a lock file in a folder of the application, never next to the user's
/// file; a claim of a process that no longer exists on this computer does not count. It does not prevent
/// saving: a save compares the file on disk first. Thread: UI.
class EditClaim final : public QObject {
    Q_OBJECT

public:
    /// The folder in which the application keeps the claims.
    [[nodiscard]] static QString defaultRoot();

    explicit EditClaim(QString root, QObject* parent = nullptr);
    ~EditClaim() override;

    /// The file of this window (empty: none), and whether it has unsaved changes here.
    void follow(const QString& file, bool modified);
    /// The other window's process that has unsaved changes of the file, if there is one.
    [[nodiscard]] const std::optional<EditHolder>& other() const { return m_other; }

signals:
    void otherChanged();

private:
    void look();
    [[nodiscard]] std::optional<EditHolder> findOther();

    QString m_root;
    QString m_file;
    bool m_modified = false;
    std::unique_ptr<QLockFile> m_lock; ///< for m_file; null: no claim
    std::optional<EditHolder> m_other;
    QTimer m_timer; ///< polls, because other windows send no notification
};

} // namespace proveout
