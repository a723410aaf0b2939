// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/compare_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include "ui/document/file_paths.h"
#include "ui/files/difference_view.h"
#include "ui/look/panel_layout.h"

namespace proveout {

namespace {

constexpr QSize kSize{760, 520};

} // namespace

Comparison comparisonOf(const DiskConflict& conflict) {
    return {QFileInfo(toQString(conflict.file)).fileName(), conflict.other.text(), conflict.mine,
            CompareDialog::tr("in this window")};
}

CompareDialog::CompareDialog(const std::vector<Comparison>& comparisons, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Compare"));
    resize(kSize);
    auto* layout = new QVBoxLayout(this);
    if (comparisons.size() == 1) {
        layout->addWidget(makePage(comparisons.front()), 1);
    } else {
        auto* pages = new QTabWidget(this);
        for (const Comparison& each : comparisons)
            pages->addTab(makePage(each), each.title);
        layout->addWidget(pages, 1);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
}

QWidget* CompareDialog::makePage(const Comparison& comparison) {
    auto* page = new QWidget(this);
    auto* view = new DifferenceView(page);
    view->show(comparison.before, comparison.after, kMostLines);
    view->setAccessibleName(tr("Differences of %1").arg(comparison.title));
    auto* summary = wrappedLabel(page);
    summary->setTextFormat(Qt::PlainText); // the names come from the user
    if (view->changeCount() == 0)
        summary->setText(tr("Both versions of %1 have the same lines.").arg(comparison.title));
    else
        summary->setText(comparison.title + u'\n' +
                         tr("\u2212 lines only on disk: %1").arg(view->removedLines()) + u'\n' +
                         tr("+ lines only %1: %2").arg(comparison.afterName).arg(view->addedLines()));
    auto* previous = new QPushButton(tr("&Previous Difference"), page);
    auto* next = new QPushButton(tr("&Next Difference"), page);
    for (QPushButton* button : {previous, next}) {
        button->setAutoDefault(false);
        button->setEnabled(view->changeCount() > 0);
    }
    connect(previous, &QPushButton::clicked, view, [view] { view->go(-1); });
    connect(next, &QPushButton::clicked, view, [view] { view->go(1); });
    auto* head = new QHBoxLayout;
    head->addWidget(summary, 1);
    head->addWidget(previous, 0, Qt::AlignBottom);
    head->addWidget(next, 0, Qt::AlignBottom);
    auto* layout = new QVBoxLayout(page);
    layout->addLayout(head);
    layout->addWidget(view, 1);
    if (view->isCut()) {
        auto* note = wrappedLabel(page);
        note->setText(tr("Only the first %1 lines are shown.").arg(kMostLines));
        layout->addWidget(note);
    }
    return page;
}

} // namespace proveout
