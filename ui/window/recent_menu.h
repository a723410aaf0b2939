// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

namespace proveout {

class FileFlow;

/// The recent files, with missing ones greyed out, and an item to clear the list.
class RecentMenu final : public QMenu {
    Q_OBJECT

public:
    /// `files` must outlive the menu.
    RecentMenu(FileFlow& files, QWidget* parent);

private:
    void fill();
    void greyMissing();

    FileFlow& m_files;
};

} // namespace proveout
