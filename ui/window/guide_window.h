// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QListWidget;
class QTextBrowser;
class QToolBar;
class QUrl;

namespace proveout {

/// The user guide in a window of its own: the list of pages and the current page. The pages are Markdown
/// files of the product (guidePages()), in English.
class GuideWindow final : public QWidget {
    Q_OBJECT

public:
    explicit GuideWindow(QWidget* parent);

    /// Opens the window, or brings it to the front, with a page such as "setup", or the first page if that
    /// does not exist.
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

/// The page about the panel that contains a widget; the first page if it is in no panel.
[[nodiscard]] QString guidePageOf(const QWidget* widget);

/// Opens the guide of a window at the page about the focused widget; `view`: the 3D view, considered only if
/// it shows something (`hasView`).
void openGuide(QWidget& window, const QWidget& view, bool hasView);

} // namespace proveout
