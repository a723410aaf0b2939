// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/document/recent_files.h"
#include "ui/look/appearance.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace proveout {

/// Shown while no document is open, and on request: open a file, a recent one or a sample; choose the
/// language; return to the open document.
class StartPage final : public QWidget {
    Q_OBJECT

public:
    /// All arguments must outlive the page.
    StartPage(Appearance& appearance, RecentFiles& recent, QWidget* parent = nullptr);

    /// The name of the open document, for the button that returns to it; empty if there is none.
    void setOpenDocument(const QString& name);

signals:
    void openWanted();
    void newWanted();
    void fileWanted(const QString& file);
    void backWanted();

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeSamples();
    QWidget* makeRecent();
    QWidget* makeFooter();
    QPushButton* addFile(QVBoxLayout& column, const QString& text, const QString& file);
    void refresh();
    void retranslate();

    Appearance& m_appearance;
    RecentFiles& m_recent;
    QLabel* m_logo;
    QLabel* m_title;
    QLabel* m_subtitle;
    QPushButton* m_open;
    QPushButton* m_new;
    QPushButton* m_back;
    QString m_openDocument;
    QLabel* m_samplesTitle;
    QVBoxLayout* m_samples;
    QLabel* m_recentTitle;
    QVBoxLayout* m_recentList;
    QLabel* m_dropHint;
    QLabel* m_languageLabel;
    QComboBox* m_language;
};

} // namespace proveout
