// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

namespace proveout {

/// The text in a plot that says how its missing values are measured. Thread: UI.
class PlotHint {
public:
    explicit PlotHint(QCustomPlot& plot); ///< the plot owns the text

    void retranslate();
    void style(const QFont& font, const QColor& text, const QColor& ground);
    /// `empty`: there are no curves, so the text takes their place.
    void setEmpty(bool empty);
    /// Some blocks were only passed on the way to another one, and have no values in this plot.
    void setIncomplete(bool incomplete);
    [[nodiscard]] QString text() const { return m_text->visible() ? m_text->text() : QString(); }

private:
    void update();

    QCPItemText* m_text;
    bool m_empty = true;
    bool m_incomplete = false;
};

} // namespace proveout
