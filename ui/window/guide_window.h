// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QListWidget;
class QTextBrowser;
class QToolBar;
class QUrl;

namespace proveout {

/// The user guide in a window of its own: its pages, and the one that is read. The pages are Markdown files
/// of the product (guidePages()), in English.
class GuideWindow final : public QWidget {
    Q_OBJECT

public:
    explicit GuideWindow(QWidget* parent);

    /// Opens the window, or brings it to the front, at a page: "setup". The first page where there is none.
    void showPage(const QString& page);

protected:
    void changeEvent(QEvent* event) override;

private:
    void makeTools();
    void listPages();
    void followText(const QUrl& shown);
    void styleText();
    void retranslate();

    QToolBar* m_tools;
    QListWidget* m_pages;
    QTextBrowser* m_text;
    QAction* m_back;
    QAction* m_forward;
};

/// The page of the panel that a widget is part of; the first page where it is part of none.
[[nodiscard]] QString guidePageOf(const QWidget* widget);

/// Opens the guide of a window at the page about what has the focus; `view`: the 3D view, once there is
/// something in it (`hasView`).
void openGuide(QWidget& window, const QWidget& view, bool hasView);

} // namespace proveout
