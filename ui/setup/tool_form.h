// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include <QWidget>

#include "core/cutter/tool_spec.h"

class QComboBox;
class QFormLayout;

namespace proveout {

/// Shape and sizes of one tool, created from the table of shapes.
class ToolForm final : public QWidget {
    Q_OBJECT

public:
    explicit ToolForm(QWidget* parent = nullptr);
    /// Shows another tool; emits nothing.
    void show(const ToolSpec& spec);
    [[nodiscard]] const ToolSpec& spec() const { return m_spec; }

signals:
    void edited();

protected:
    void changeEvent(QEvent* event) override;

private:
    void chooseShape(int index);
    void build();
    void addKey(const ShapeKey& key);
    [[nodiscard]] QWidget* numberBox(const ShapeKey& key);
    [[nodiscard]] QWidget* textBox(const ShapeKey& key);
    [[nodiscard]] static QString textHint(const ShapeKey& key);
    void showNumber(const std::string& key, double value);
    void showText(const std::string& key, const std::string& text);
    void nameShapes();

    ToolSpec m_spec;
    QComboBox* m_shape;
    QFormLayout* m_layout;
};

} // namespace proveout
