// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include <QWidget>

#include "core/nc/program/program.h"
#include "core/simulation/setup/setup.h"

class QLabel;
class QLineEdit;

namespace proveout {

/// The list of M codes that move no axis of the machine, and below it those that the program contains and
/// that are ignored.
class IgnoredCodesField final : public QWidget {
    Q_OBJECT

public:
    explicit IgnoredCodesField(QWidget* parent = nullptr);

    void show(const Setup& setup);
    /// Discards unfinished or invalid text, because it belongs to the previous document.
    void dropText();
    /// Shows the codes that `program` ignores; null: none yet.
    void showProgram(const Program* program);
    /// A list that cannot be read changes nothing.
    void put(Setup& setup) const;

signals:
    void edited();

protected:
    void changeEvent(QEvent* event) override;

private:
    void finish();
    void retranslate();

    QLabel* m_label;
    QLineEdit* m_list;
    QLabel* m_problem;
    QLabel* m_found;
    std::set<int> m_shown;
    IgnoredCodes m_ignored; ///< of the program
};

} // namespace proveout
