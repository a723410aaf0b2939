// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMainWindow;

namespace proveout {

class FileFlow;

/// Opens a file that is dropped on a window; during the drag, the status bar explains why a file cannot be
/// opened. Thread: UI.
class FileDrop final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    FileDrop(FileFlow& files, QMainWindow& window);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    FileFlow& m_files;
    QMainWindow& m_window;
};

} // namespace proveout
