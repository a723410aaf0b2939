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

/// Shown while nothing is open, and when it is asked for: open a file, a recent one, or a sample; choose the
/// language; go back to what is open.
class StartPage final : public QWidget {
    Q_OBJECT

public:
    /// All arguments outlive the page.
    StartPage(Appearance& appearance, RecentFiles& recent, QWidget* parent = nullptr);

    /// What is open, for the way back to it; empty where nothing is.
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
