// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QString>
#include <QTimer>

class QLockFile;

namespace proveout {

/// The process of a window that has unsaved changes of a file. Value type.
struct EditHolder {
    qint64 process = 0;
    QString computer;

    friend bool operator==(const EditHolder&, const EditHolder&) = default;
};

/// Says to the other windows of this user that a file has unsaved changes here, and notices where it has them
/// in another one. A claim is a lock file in a folder of the application, never beside the user's file; that
/// of a process which no longer exists on this computer does not count. It keeps nobody from saving: what is
/// saved is compared with the disk. Thread: UI.
class EditClaim final : public QObject {
    Q_OBJECT

public:
    /// Where the application keeps the claims.
    [[nodiscard]] static QString defaultRoot();

    explicit EditClaim(QString root, QObject* parent = nullptr);
    ~EditClaim() override;

    /// The file of this window (empty: none), and whether it has unsaved changes here.
    void follow(const QString& file, bool modified);
    /// Who else has unsaved changes of it.
    [[nodiscard]] const std::optional<EditHolder>& other() const { return m_other; }

signals:
    void otherChanged();

private:
    void look();
    [[nodiscard]] std::optional<EditHolder> findOther();

    QString m_root;
    QString m_file;
    bool m_modified = false;
    std::unique_ptr<QLockFile> m_lock; ///< of m_file; null: none
    std::optional<EditHolder> m_other;
    QTimer m_timer; ///< others come and go without a word
};

} // namespace proveout
