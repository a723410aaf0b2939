// SPDX-License-Identifier: GPL-3.0-or-later
// Who saves under a name, is asked whether to overwrite, and says no.
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

/// Works the next save dialog while it lives: types `name`, accepts, refuses to overwrite, and cancels.
class SaveDialogUser : public QObject {
public:
    explicit SaveDialogUser(const QString& name) : m_name(name) {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs); // there is no working those
        connect(&m_look, &QTimer::timeout, this, [this] { act(QApplication::activeModalWidget()); });
        m_look.start(20);
    }
    /// What was asked before overwriting; empty where nothing was.
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
            // Later: a timer does not fire while what it has called waits for an answer.
            QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
        }
    }

    QString m_name;
    QString m_question;
    bool m_typed = false;
    QTimer m_look;
};

} // namespace proveout
