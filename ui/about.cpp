// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/about.h"

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
                 translated(QT_TRANSLATE_NOOP("About", "The shown surface is decimated locally, by the "
                                                       "method of Lee and Lee, while it is cut.")),
                 translated(QT_TRANSLATE_NOOP("About",
                                              "Free software under the GNU General Public License, version 3 "
                                              "or later. It comes with no "
                                              "warranty; nothing here replaces care at the machine.")));
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
             translated(QT_TRANSLATE_NOOP("About", "Left button")));
    addMouse(translated(QT_TRANSLATE_NOOP("About", "Pan")),
             translated(QT_TRANSLATE_NOOP("About", "Middle button, or Shift and left button")));
    addMouse(translated(QT_TRANSLATE_NOOP("About", "Zoom")), translated(QT_TRANSLATE_NOOP("About", "Wheel")));
    addMouse(translated(QT_TRANSLATE_NOOP("About", "Go to the block that made this")),
             translated(QT_TRANSLATE_NOOP("About", "Ctrl and left button, or the menu of the right button")));
    mouse->setExpanded(true);
    list->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(list);
    dialog->resize(kListSize);
    dialog->show();
}

} // namespace proveout
