// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_drop.h"

#include <QDropEvent>
#include <QMainWindow>
#include <QStatusBar>

#include "ui/files/file_flow.h"

namespace proveout {

namespace {

constexpr int kReasonTime = 5000; ///< ms

} // namespace

FileDrop::FileDrop(FileFlow& files, QMainWindow& window)
    : QObject(&window), m_files(files), m_window(window) {
    window.setAcceptDrops(true);
    window.installEventFilter(this);
}

bool FileDrop::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
        return QObject::eventFilter(watched, event);
    auto& drop = static_cast<QDropEvent&>(*event);
    QString reason;
    const QString file = FileFlow::droppedFile(*drop.mimeData(), reason);
    if (drop.type() == QEvent::Drop) {
        if (!file.isEmpty())
            m_files.open(file);
    } else if (!file.isEmpty()) {
        drop.acceptProposedAction();
    } else {
        m_window.statusBar()->showMessage(reason, kReasonTime);
    }
    return true;
}

} // namespace proveout
