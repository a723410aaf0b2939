// SPDX-License-Identifier: GPL-3.0-or-later
// Plays a user who saves under a name and declines to overwrite an existing file.
#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QObject>
#include <QString>
#include <QTimer>

namespace proveout {

/// Operates the next save dialog while this object exists: types `name`, accepts, refuses to overwrite, and
/// cancels.
class SaveDialogUser : public QObject {
public:
    explicit SaveDialogUser(const QString& name) : m_name(name) {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs); // a test cannot operate native ones
        connect(&m_look, &QTimer::timeout, this, [this] { act(QApplication::activeModalWidget()); });
        m_look.start(20);
    }
    /// The text of the overwrite question; empty if there was none.
    [[nodiscard]] const QString& question() const { return m_question; }

private:
    void act(QWidget* widget) {
        if (auto* box = qobject_cast<QMessageBox*>(widget)) {
            m_question = box->text();
            box->button(QMessageBox::No)->click();
        } else if (auto* dialog = qobject_cast<QFileDialog*>(widget)) {
            if (m_typed) {
                dialog->reject();
                return;
            }
            m_typed = true;
            dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(m_name);
            // Queued, because a timer does not fire while its slot waits for an answer.
            QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
        }
    }

    QString m_name;
    QString m_question;
    bool m_typed = false;
    QTimer m_look;
};

} // namespace proveout
