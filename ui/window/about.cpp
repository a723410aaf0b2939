// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/about.h"

#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QDialog>
#include <QHeaderView>
#include <QMenu>
#include <QMessageBox>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace proveout {

namespace {

constexpr QSize kListSize{520, 560};

QString translated(const char* text) {
    return QCoreApplication::translate("About", text);
}

QString withoutMnemonic(QString text) {
    return text.remove(QLatin1Char('&'));
}

void addKeys(QTreeWidgetItem& group, const QMenu& menu) {
    for (const QAction* action : menu.actions()) {
        if (const QMenu* inner = action->menu()) {
            addKeys(group, *inner);
        } else if (!action->shortcut().isEmpty()) {
            QStringList keys;
            for (const QKeySequence& key : action->shortcuts())
                keys << key.toString(QKeySequence::NativeText);
            new QTreeWidgetItem(&group, {withoutMnemonic(action->text()), keys.join(QStringLiteral(", "))});
        }
    }
}

} // namespace

void showAbout(QWidget& window) {
    const QString text =
        QStringLiteral("<h2>Proveout %1</h2><p>%2</p><p>%3</p><p>%4</p>")
            .arg(QCoreApplication::applicationVersion(),
                 translated(QT_TRANSLATE_NOOP(
                     "About", "Proves out three-axis milling programs before they touch metal.")),
                 translated(QT_TRANSLATE_NOOP("About", "The displayed surface is decimated locally while it "
                                                       "is cut, by the method of Lee and Lee.")),
                 translated(QT_TRANSLATE_NOOP(
                     "About", "Free software under the GNU General Public License, version 3 or later. There "
                              "is no warranty. Prove out every new program at the machine, too.")));
    QMessageBox::about(&window, translated(QT_TRANSLATE_NOOP("About", "About Proveout")), text);
}

void showShortcutList(QWidget& window, const QMenuBar& menus) {
    auto* dialog = new QDialog(&window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(translated(QT_TRANSLATE_NOOP("About", "Keys and Mouse")));
    auto* list = new QTreeWidget(dialog);
    list->setHeaderLabels(
        {translated(QT_TRANSLATE_NOOP("About", "Command")), translated(QT_TRANSLATE_NOOP("About", "Keys"))});
    for (const QAction* action : menus.actions()) {
        auto* group = new QTreeWidgetItem(list, {withoutMnemonic(action->text())});
        addKeys(*group, *action->menu());
        group->setExpanded(true);
    }
    auto* mouse = new QTreeWidgetItem(list, {translated(QT_TRANSLATE_NOOP("About", "3D view"))});
    const auto addMouse = [mouse](const QString& what, const QString& how) {
        new QTreeWidgetItem(mouse, {what, how});
    };
    addMouse(translated(QT_TRANSLATE_NOOP("About", "Orbit")),
             translated(QT_TRANSLATE_NOOP("About", "Left drag, or Alt+arrow keys")));
    addMouse(translated(QT_TRANSLATE_NOOP("About", "Pan")),
             translated(QT_TRANSLATE_NOOP("About", "Middle drag, or Shift+left drag")));
    addMouse(translated(QT_TRANSLATE_NOOP("About", "Zoom")), translated(QT_TRANSLATE_NOOP("About", "Wheel")));
    addMouse(translated(QT_TRANSLATE_NOOP("About", "Centre a point and orbit about it")),
             translated(QT_TRANSLATE_NOOP("About", "Double-click with the middle button")));
    addMouse(translated(QT_TRANSLATE_NOOP("About", "Go to the cutting block of a point")),
             translated(QT_TRANSLATE_NOOP("About", "Ctrl+click, or G and click, or right-click")));
    addMouse(translated(QT_TRANSLATE_NOOP("About", "Magnify a detail")),
             translated(QT_TRANSLATE_NOOP("About", "B and drag a box, or B and click")));
    mouse->setExpanded(true);
    list->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(list);
    dialog->resize(kListSize);
    dialog->show();
}

} // namespace proveout
