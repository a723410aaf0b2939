// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

namespace proveout {

class Session;

/// The verdict on the open program, with its reasons in the tooltip: colour, icon and words. A click is for
/// the window: it shows the findings. Thread: UI.
class VerdictBadge final : public QToolButton {
    Q_OBJECT

public:
    /// `session` must outlive this object.
    explicit VerdictBadge(const Session& session, QWidget* parent = nullptr);
    /// Whether there is anything to show.
    [[nodiscard]] bool hasVerdict() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// hasVerdict() may have changed.
    void shown();

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void showVerdict();
    void showText();

    const Session& m_session;
};

} // namespace proveout
