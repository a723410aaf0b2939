// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QHBoxLayout;
class QLabel;

namespace proveout {

/// A message over the view, with buttons to fix the problem. It stays centred at the lower edge of its
/// parent.
class ViewNotice : public QFrame {
    Q_OBJECT

public:
    explicit ViewNotice(QWidget* parent);

protected:
    /// The row of the message: icon, text, and further widgets.
    [[nodiscard]] QHBoxLayout& sentenceRow() { return *m_sentence; }
    [[nodiscard]] QHBoxLayout& buttonRow() { return *m_buttons; }
    void showText(const QString& iconName, const QString& text);
    void place();
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLabel* m_icon;
    QLabel* m_text; ///< its object name is "noticeText"
    QHBoxLayout* m_sentence;
    QHBoxLayout* m_buttons;
};

} // namespace proveout
