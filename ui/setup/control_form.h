// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "core/simulation/setup/setup_fields.h"
#include "ui/session/session.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QVBoxLayout;

namespace proveout {

class IgnoredCodesField;
class StartForm;

/// The settings of the control: the rows of eachControlField(). An on/off setting or one with two choices
/// gets its widget from its description, named like its option; the others have forms of their own.
class ControlForm final : public QWidget {
    Q_OBJECT

public:
    explicit ControlForm(Session& session, QWidget* parent = nullptr);

    /// Shows the values of the setup, and what the current program says about them; emits nothing.
    void show(const Setup& setup);
    /// Shows what depends on the program: the assumed tool, the names of the dialect and of the ignored
    /// codes, and the rows that its control has.
    void showProgram(const Setup& setup);
    /// Discards unfinished or invalid text, because it belongs to the previous document.
    void dropText();
    void put(Setup& setup) const;

signals:
    void edited();

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Switch {
        const Field* field = nullptr;
        QCheckBox* box = nullptr; ///< or
        QLabel* label = nullptr;
        QComboBox* choices = nullptr;
    };

    void build();
    void addSwitches(QVBoxLayout& layout, bool (*wanted)(const Field&));
    [[nodiscard]] Switch makeSwitch(const Field& field, QVBoxLayout& layout);
    [[nodiscard]] QString automaticDialect() const;
    void showCompensation();
    void retranslate();

    Session& m_session;
    QLabel* m_dialectLabel;
    QComboBox* m_dialect;
    std::vector<Switch> m_switches; ///< same order as the rows
    IgnoredCodesField* m_ignored = nullptr;
    StartForm* m_start = nullptr;
};

} // namespace proveout
