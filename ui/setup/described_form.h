// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "core/cutting/fixtures/fixture.h"

class QFormLayout;
class QLabel;

namespace proveout {

class NumberBox;

/// Number fields for a struct of lengths, created from its description; named by the keys after `prefix`.
/// Thread: UI.
class DescribedForm final : public QWidget {
    Q_OBJECT

public:
    explicit DescribedForm(QString prefix, QWidget* parent = nullptr);

    /// Shows the values; emits nothing. Fields are made again where they differ from those before.
    template<class Described>
    void show(Described values) {
        std::vector<Shown> rows;
        describe(values, [&](double value, const Field& field) { rows.push_back({field, value}); });
        showRows(rows);
    }
    /// Writes the numbers to values of the struct that was shown last.
    template<class Described>
    void put(Described& values) const {
        std::size_t row = 0;
        describe(values, [&](double& value, const Field&) { read(row++, value); });
    }

    /// Selects the first number for typing.
    void selectFirst();

signals:
    void edited();

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Shown {
        Field field;
        double value = 0;
    };
    struct Row {
        Field field;
        QLabel* label = nullptr;
        NumberBox* box = nullptr;
    };

    void showRows(const std::vector<Shown>& rows);
    [[nodiscard]] bool hasFieldsOf(const std::vector<Shown>& rows) const;
    void addRow(const Field& field);
    void read(std::size_t row, double& value) const;
    void retranslate();

    QString m_prefix;
    QFormLayout* m_layout;
    std::vector<Row> m_rows;
};

} // namespace proveout
