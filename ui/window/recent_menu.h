// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

namespace proveout {

class FileFlow;

/// The recent files, missing ones greyed, and an entry to forget them.
class RecentMenu final : public QMenu {
    Q_OBJECT

public:
    /// `files` outlives the menu.
    RecentMenu(FileFlow& files, QWidget* parent);

private:
    void fill();
    void greyMissing();

    FileFlow& m_files;
};

} // namespace proveout
