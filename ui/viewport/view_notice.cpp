// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/view_notice.h"

#include <algorithm>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/look/icons.h"

namespace proveout {

namespace {

constexpr int kMargin = 12; // px
constexpr int kWidest = 560;
constexpr int kIcon = 20;

} // namespace

ViewNotice::ViewNotice(QWidget* parent)
    : QFrame(parent), m_icon(new QLabel(this)), m_text(new QLabel(this)), m_sentence(new QHBoxLayout),
      m_buttons(new QHBoxLayout) {
    m_text->setObjectName(QStringLiteral("noticeText"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText); // the text quotes the user's file
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    m_sentence->addWidget(m_icon, 0, Qt::AlignTop);
    m_sentence->addWidget(m_text, 1);
    m_buttons->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(m_sentence);
    layout->addLayout(m_buttons);
    parent->installEventFilter(this);
}

void ViewNotice::showText(const QString& iconName, const QString& text) {
    m_icon->setPixmap(icon(iconName).pixmap(kIcon));
    m_text->setText(text);
    place();
}

void ViewNotice::place() {
    const int width = std::min(kWidest, parentWidget()->width() - 2 * kMargin);
    const int height = hasHeightForWidth() ? heightForWidth(width) : sizeHint().height();
    setGeometry((parentWidget()->width() - width) / 2, parentWidget()->height() - height - kMargin, width,
                height);
}

/// The height of the text is known only once it has its font and width.
bool ViewNotice::event(QEvent* event) {
    const bool done = QFrame::event(event);
    if (event->type() == QEvent::Show || event->type() == QEvent::LayoutRequest)
        place();
    return done;
}

bool ViewNotice::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(watched, event);
}

} // namespace proveout
