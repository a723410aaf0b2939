// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dock_titles.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QStyle>
#include <QStyleOption>
#include <QToolButton>

namespace proveout {

namespace {

constexpr int kButtonIcon = 10; // px
constexpr int kGripMargin = 4;
constexpr int kDotGap = 4;
constexpr int kMostDots = 12;

/// The handle for dragging a dock whose title is a tab.
class DockGrip final : public QWidget {
public:
    explicit DockGrip(QDockWidget& dock) : QWidget(&dock) {
        auto* layout = new QHBoxLayout(this);
        layout->setContentsMargins(kGripMargin, 0, 0, 0);
        layout->setSpacing(0);
        layout->addStretch(1);
        addButton(*layout, QStyle::SP_TitleBarNormalButton, [&dock] {
            dock.setFloating(!dock.isFloating());
        })->setObjectName(QStringLiteral("float-dock"));
        addButton(*layout, QStyle::SP_TitleBarCloseButton, [&dock] {
            dock.close();
        })->setObjectName(QStringLiteral("close-dock"));
        retranslate();
    }

protected:
    void changeEvent(QEvent* event) override {
        QWidget::changeEvent(event);
        if (event->type() == QEvent::LanguageChange)
            retranslate();
    }

    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setPen(palette().color(QPalette::PlaceholderText));
        const int middle = height() / 2;
        for (int dot = 0; dot < kMostDots; ++dot) {
            const int x = kGripMargin + dot * kDotGap;
            painter.drawPoint(x, middle - 1);
            painter.drawPoint(x, middle + 1);
        }
    }

private:
    template<class Run>
    QToolButton* addButton(QHBoxLayout& layout, QStyle::StandardPixmap picture, Run run) {
        auto* button = new QToolButton(this);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::NoFocus);
        button->setIcon(style()->standardIcon(picture));
        button->setIconSize({kButtonIcon, kButtonIcon});
        connect(button, &QToolButton::clicked, this, run);
        layout.addWidget(button);
        m_buttons.push_back(button);
        return button;
    }

    void retranslate() {
        m_buttons[0]->setToolTip(QCoreApplication::translate("DockTitles", "Float or dock this panel"));
        m_buttons[1]->setToolTip(QCoreApplication::translate("DockTitles", "Close this panel"));
        for (QToolButton* button : m_buttons)
            button->setAccessibleName(button->toolTip());
    }

    std::vector<QToolButton*> m_buttons;
};

} // namespace

DockTitles::DockTitles(QMainWindow& window, std::vector<QDockWidget*> docks)
    : QObject(&window), m_window(window), m_docks(std::move(docks)) {
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &DockTitles::update);
    const auto later = [this] { m_soon.start(0); };
    for (QDockWidget* dock : m_docks) {
        connect(dock, &QDockWidget::dockLocationChanged, this, later);
        connect(dock, &QDockWidget::topLevelChanged, this, later);
        connect(dock, &QDockWidget::visibilityChanged, this, later);
        dock->installEventFilter(this);
    }
    later();
}

bool DockTitles::eventFilter(QObject* watched, QEvent* event) {
    // Restoring a layout moves docks without a signal.
    if (event->type() == QEvent::Move || event->type() == QEvent::Show || event->type() == QEvent::Hide)
        m_soon.start(0);
    return QObject::eventFilter(watched, event);
}

bool DockTitles::isTab(QDockWidget& dock) const {
    if (dock.isFloating())
        return false;
    const QList<QDockWidget*> others = m_window.tabifiedDockWidgets(&dock);
    return std::any_of(others.begin(), others.end(),
                       [](const QDockWidget* other) { return other->toggleViewAction()->isChecked(); });
}

void DockTitles::update() {
    for (QDockWidget* dock : m_docks) {
        const bool tab = isTab(*dock);
        QWidget* grip = dock->titleBarWidget();
        if (tab == (grip != nullptr))
            continue;
        dock->setTitleBarWidget(tab ? new DockGrip(*dock) : nullptr);
        if (!tab)
            grip->deleteLater(); // this may be called by one of its buttons
    }
}

} // namespace proveout
