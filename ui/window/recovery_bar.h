// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDateTime>
#include <QFrame>
#include <QString>

class QLabel;

namespace proveout {

/// A session with backed-up work, as the bar shows it.
struct RecoveryRow {
    QString key;
    QString name; ///< name of the file; empty: a new program
    bool text = false;
    bool setup = false;
    QDateTime time;

    friend bool operator==(const RecoveryRow&, const RecoveryRow&) = default;
};

/// "Proveout ended unexpectedly. Unsaved changes were kept", with one row per session: restore, compare,
/// discard. Hidden while there is none.
class RecoveryBar final : public QFrame {
    Q_OBJECT

public:
    explicit RecoveryBar(QWidget* parent = nullptr);

    void showRows(std::vector<RecoveryRow> rows);

signals:
    void restoreWanted(const QString& key);
    void compareWanted(const QString& key);
    void discardWanted(const QString& key);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fill();
    void addRow(const RecoveryRow& row, int line);

    std::vector<RecoveryRow> m_rows;
    QLabel* m_title;
    QWidget* m_list = nullptr;
};

} // namespace proveout
