// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/appearance.h"
#include "ui/recent_files.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace proveout {

/// Shown while nothing is open: open a file, a recent one, or a sample; choose the language.
class StartPage final : public QWidget {
    Q_OBJECT

public:
    /// All arguments outlive the page.
    StartPage(Appearance& appearance, RecentFiles& recent, QWidget* parent = nullptr);

signals:
    void openWanted();
    void newWanted();
    void fileWanted(const QString& file);

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
    QLabel* m_samplesTitle;
    QVBoxLayout* m_samples;
    QLabel* m_recentTitle;
    QVBoxLayout* m_recentList;
    QLabel* m_dropHint;
    QLabel* m_languageLabel;
    QComboBox* m_language;
};

} // namespace proveout
