// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QTimer>
#include <QWidget>

#include "core/part/part_spec.h"
#include "ui/session/session.h"

class QLabel;
class QToolButton;

namespace proveout {

class ElidedLabel;
class NumberBox;

/// The file of the design part, its place and its tolerance. UI thread.
class PartForm final : public QWidget {
    Q_OBJECT

public:
    explicit PartForm(Session& session, QWidget* parent = nullptr);

    void askForFile();
    /// Its zero is that of the program, as most are exported.
    void setFile(const QString& file);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void showPart();
    void apply();
    void retranslate();

    Session& m_session;
    ElidedLabel* m_file;
    QToolButton* m_choose;
    QToolButton* m_remove;
    std::vector<QLabel*> m_labels; ///< same order as the fields
    std::vector<NumberBox*> m_boxes;
    QTimer m_rest;
};

} // namespace proveout
