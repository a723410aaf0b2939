// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/monkey/monkey.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QTabBar>
#include <QWheelEvent>
#include <QWindow>

#include "ui/look/languages.h"
#include "ui/look/theme.h"

namespace proveout {

namespace {

constexpr int kLook = 30;            // ms between checks of the topmost dialog or menu
constexpr int kWheelStep = 120;      // eighths of a degree
constexpr int kLongestDrag = 300;    // ms
constexpr int kMostOnTop = 12;       // actions on a dialog or menu before it is closed
constexpr int kSmallestWindow = 300; // px
constexpr QSize kLargestWindow{1500, 950};

constexpr std::array kButtons{Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::RightButton,
                              Qt::MiddleButton};
constexpr std::array<Qt::KeyboardModifiers::Int, 6> kModifiers{
    Qt::NoModifier,      Qt::NoModifier,    Qt::NoModifier,
    Qt::ControlModifier, Qt::ShiftModifier, Qt::ControlModifier | Qt::ShiftModifier};
constexpr std::array kKeys{
    Qt::Key_Space,  Qt::Key_Left,   Qt::Key_Right,     Qt::Key_Up,  Qt::Key_Down,    Qt::Key_Home,
    Qt::Key_End,    Qt::Key_PageUp, Qt::Key_PageDown,  Qt::Key_Tab, Qt::Key_Backtab, Qt::Key_Return,
    Qt::Key_Escape, Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_F3,  Qt::Key_F8,      Qt::Key_F9,
    Qt::Key_F11,    Qt::Key_Plus,   Qt::Key_Minus,     Qt::Key_0,   Qt::Key_1,       Qt::Key_2,
    Qt::Key_3,      Qt::Key_4,      Qt::Key_5,         Qt::Key_6,   Qt::Key_7,       Qt::Key_8,
    Qt::Key_9,      Qt::Key_A,      Qt::Key_B,         Qt::Key_F,   Qt::Key_G,       Qt::Key_L,
    Qt::Key_P,      Qt::Key_V,      Qt::Key_W,         Qt::Key_X,   Qt::Key_Y,       Qt::Key_Z};
constexpr std::array<std::string_view, 14> kTexts{"G1 X10 Y20 F300\n",
                                                  "G0 Z5\n",
                                                  "G2 X5 I-3 (arc\n",
                                                  "M6 T7\n",
                                                  "T0\n",
                                                  "G83 Z-5 R1 Q0.0001 F50\n",
                                                  "#1=[2/0]\n",
                                                  "0",
                                                  "-1",
                                                  "1e9",
                                                  "0.01",
                                                  "12,5",
                                                  "flat mill",
                                                  "nan"};

template<class Table>
const auto& oneOf(const Table& table, int index) {
    return table[static_cast<std::size_t>(index)];
}

/// Only copies are opened, edited and overwritten.
QStringList copyPrograms(const QString& folder) {
    QStringList files;
    const QDir source(QStringLiteral(PROVEOUT_SOURCE_DIR "/resources/samples"));
    for (const QFileInfo& file : source.entryInfoList({"*.nc", "*.proveout"}, QDir::Files)) {
        const QString copy = folder + u'/' + file.fileName();
        if (QFile::copy(file.filePath(), copy))
            files << copy;
    }
    const QDir cases(QStringLiteral(PROVEOUT_SOURCE_DIR "/tests/data/nc"));
    for (const char* name :
         {"cycle-g81", "arc-helix", "o-loops", "compensation-corner", "unknown-code", "inch"}) {
        const QString copy = folder + u'/' + QLatin1String(name) + QStringLiteral(".ngc");
        if (QFile::copy(cases.filePath(QLatin1String(name) + QStringLiteral("/program.ngc")), copy))
            files << copy;
    }
    return files;
}

QString named(const QWidget& widget) {
    QString text = QLatin1String(widget.metaObject()->className());
    if (!widget.objectName().isEmpty())
        text += u'#' + widget.objectName();
    return text;
}

} // namespace

/// The actions of the monkey, one per row.
struct Monkey::Act {
    const char* name;
    int weight;
    void (Monkey::*run)();
};

const std::vector<Monkey::Act>& Monkey::acts() {
    static const std::vector<Act> kActs{
        {"click", 30, &Monkey::click},    {"drag", 10, &Monkey::drag},
        {"wheel", 10, &Monkey::wheel},    {"keys", 25, &Monkey::pressKeys},
        {"type", 8, &Monkey::typeNumber}, {"action", 15, &Monkey::triggerAction},
        {"tab", 5, &Monkey::chooseTab},   {"file", 2, &Monkey::changeFile},
        {"open", 1, &Monkey::openFile},   {"look", 1, &Monkey::changeLook},
        {"resize", 1, &Monkey::resize},   {"wait", 4, &Monkey::wait},
    };
    return kActs;
}

Monkey::Monkey(std::uint32_t seed, QString folder)
    : m_random(seed), m_folder(std::move(folder)), m_files(copyPrograms(m_folder)),
      m_log(m_folder + QStringLiteral("/monkey.log")) {
    if (!m_log.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        qFatal("no log in %s", qPrintable(m_folder));
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    // Queued, because a timer does not fire while its slot waits for the answer to a question.
    QObject::connect(
        &m_onTop, &QTimer::timeout, &m_onTop, [this] { workWhatIsOnTop(); }, Qt::QueuedConnection);
    m_onTop.start(kLook);
    restart();
}

Monkey::~Monkey() = default;

void Monkey::restart() {
    m_station.reset(); // destroyed before the next one is created, because both use the same settings
    m_station = std::make_unique<Workstation>(false);
    m_station->window.files().open(anyFile());
}

void Monkey::act() {
    if (!m_station->window.isVisible()) {
        note(QStringLiteral("restart"));
        restart();
    }
    const std::vector<Act>& rows = acts();
    const int all = std::accumulate(rows.begin(), rows.end(), 0,
                                    [](int sum, const Act& row) { return sum + row.weight; });
    int chosen = below(all);
    const Act* act = rows.data();
    while (chosen >= act->weight)
        chosen -= act++->weight;
    ++m_actions;
    (this->*act->run)();
    QCoreApplication::processEvents();
}

QString Monkey::fault() const {
    const QWidget* focus = QApplication::focusWidget();
    if (focus != nullptr && !focus->isVisible())
        return QStringLiteral("the hidden widget %1 has the focus").arg(named(*focus));
    return {};
}

int Monkey::below(int count) {
    return std::uniform_int_distribution<int>(0, std::max(count, 1) - 1)(m_random);
}

void Monkey::note(const QString& what) {
    m_log.write((QString::number(m_actions) + u' ' + what + u'\n').toUtf8());
}

QString Monkey::anyFile() {
    return m_files.isEmpty() ? QString() : m_files.at(below(static_cast<int>(m_files.size())));
}

/// A widget of the topmost window, with equal probability for small and large ones.
QWidget* Monkey::target() {
    QWidget* top = QApplication::activePopupWidget();
    if (top == nullptr)
        top = QApplication::activeModalWidget();
    if (top == nullptr)
        top = &m_station->window;
    QList<QWidget*> seen;
    for (QWidget* widget : top->findChildren<QWidget*>()) {
        if (widget->isVisible() && !widget->size().isEmpty() && !widget->visibleRegion().isEmpty())
            seen << widget;
    }
    return seen.isEmpty() ? top : seen.at(below(static_cast<int>(seen.size())));
}

namespace {

/// A point of the widget in the coordinates of its window.
QPoint inWindow(const QWidget& widget, QPoint place) {
    return widget.mapTo(widget.window(), place);
}

/// A press of a button or a key may destroy the window; it then gets no release.
void clickAt(const QPointer<QWindow>& window, Qt::MouseButton button, Qt::KeyboardModifiers modifiers,
             QPoint place, int times) {
    for (; times > 0; --times) {
        if (window != nullptr)
            QTest::mousePress(window, button, modifiers, place);
        if (window != nullptr)
            QTest::mouseRelease(window, button, modifiers, place);
    }
}

void hitKey(const QPointer<QWindow>& window, Qt::Key key, Qt::KeyboardModifiers modifiers,
            const QString& text = {}) {
    // Without presses of the modifier keys themselves, which Qt Test would send to a destroyed window.
    if (window != nullptr)
        QTest::simulateEvent(window, true, key, modifiers, text, false);
    if (window != nullptr)
        QTest::simulateEvent(window, false, key, modifiers, text, false);
}

} // namespace

void Monkey::click() {
    QWidget* widget = target();
    const QPoint place(below(widget->width()), below(widget->height()));
    const Qt::MouseButton button = oneOf(kButtons, below(kButtons.size()));
    const auto modifiers = Qt::KeyboardModifiers(oneOf(kModifiers, below(kModifiers.size())));
    note(QStringLiteral("click %1 at %2,%3 button %4 modifiers %5")
             .arg(named(*widget))
             .arg(place.x())
             .arg(place.y())
             .arg(button)
             .arg(modifiers.toInt()));
    const QPointer<QWindow> window = widget->window()->windowHandle();
    clickAt(window, button, modifiers, inWindow(*widget, place), oneIn(6) ? 2 : 1);
}

void Monkey::drag() {
    QWidget* widget = target();
    const QPoint from(below(widget->width()), below(widget->height()));
    note(QStringLiteral("drag on %1").arg(named(*widget)));
    const QPointer<QWindow> window = widget->window()->windowHandle();
    QPoint at = inWindow(*widget, from);
    const Qt::MouseButton button = oneOf(kButtons, below(kButtons.size()));
    if (window == nullptr)
        return;
    // Dragged text or tabs run their own event loop until the button is released.
    const auto release = [&] {
        if (window != nullptr)
            QTest::mouseRelease(window, button, {}, at);
    };
    QTimer drop;
    QObject::connect(&drop, &QTimer::timeout, release);
    drop.start(kLongestDrag);
    QTest::mousePress(window, button, {}, at);
    for (int step = below(8); step >= 0 && window != nullptr; --step) {
        at += QPoint(below(121) - 60, below(121) - 60);
        QTest::mouseMove(window, at);
        QCoreApplication::processEvents();
    }
    release();
}

void Monkey::wheel() {
    QWidget* widget = target();
    const QPoint place(below(widget->width()), below(widget->height()));
    note(QStringLiteral("wheel on %1").arg(named(*widget)));
    QWindow* window = widget->window()->windowHandle();
    if (window == nullptr)
        return;
    const QPoint at = inWindow(*widget, place);
    QWheelEvent event(at, window->mapToGlobal(at), {}, QPoint(0, (below(5) - 2) * kWheelStep), Qt::NoButton,
                      Qt::KeyboardModifiers(oneOf(kModifiers, below(kModifiers.size()))), Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(window, &event);
}

void Monkey::pressKeys() {
    for (int count = 1 + below(4); count > 0; --count) {
        QWidget* top = target()->window();
        const Qt::Key key = oneOf(kKeys, below(kKeys.size()));
        const auto modifiers = Qt::KeyboardModifiers(oneOf(kModifiers, below(kModifiers.size())));
        note(QStringLiteral("key %1 modifiers %2").arg(key, 0, 16).arg(modifiers.toInt()));
        hitKey(top->windowHandle(), key, modifiers);
    }
}

void Monkey::typeNumber() {
    const std::string_view text = oneOf(kTexts, below(kTexts.size()));
    note(QStringLiteral("type %1").arg(
        QString::fromUtf8(text.data(), static_cast<int>(text.size())).trimmed()));
    for (const char letter : text) {
        const QPointer<QWindow> window = target()->window()->windowHandle();
        if (letter == '\n')
            hitKey(window, Qt::Key_Return, {});
        else
            hitKey(window, QTest::asciiToKey(letter), {}, QString(QLatin1Char(letter)));
    }
}

void Monkey::triggerAction() {
    if (QApplication::activeModalWidget() != nullptr || QApplication::activePopupWidget() != nullptr)
        return; // a user could not reach the menus either
    const QList<QAction*> all = m_station->window.findChildren<QAction*>();
    QAction* action = all.at(below(static_cast<int>(all.size())));
    if (!action->isEnabled() || !action->isVisible() ||
        (action->objectName() == QLatin1String("file-quit") && !oneIn(5)))
        return;
    note(QStringLiteral("action %1 %2").arg(action->objectName(), action->text()));
    action->trigger();
}

void Monkey::chooseTab() {
    const QList<QTabBar*> bars = m_station->window.findChildren<QTabBar*>();
    if (bars.isEmpty() || QApplication::activeModalWidget() != nullptr)
        return;
    QTabBar* bar = bars.at(below(static_cast<int>(bars.size())));
    if (!bar->isVisible() || bar->count() == 0)
        return;
    const int tab = below(bar->count());
    note(QStringLiteral("tab %1").arg(bar->tabText(tab)));
    clickAt(bar->window()->windowHandle(), Qt::LeftButton, {}, inWindow(*bar, bar->tabRect(tab).center()), 1);
}

/// Changes to files by other programs.
void Monkey::changeFile() {
    const QString name = anyFile();
    const int way = below(4);
    note(QStringLiteral("file %1 way %2").arg(QFileInfo(name).fileName()).arg(way));
    if (way == 0) {
        QFile::remove(name);
        return;
    }
    QFile file(name);
    if (way == 1 && file.open(QIODevice::WriteOnly | QIODevice::Truncate)) {
        file.write("G21 G90\nG0 Z10\nG0 X0 Y0\nG1 Z-1 F100\nX50 F500\nM2\n");
    } else if (way == 2 && file.open(QIODevice::Append)) {
        file.write("\n(changed outside)\n");
    } else if (file.open(QIODevice::WriteOnly | QIODevice::Truncate)) {
        file.write(QByteArray(100, '\0'));
    }
}

void Monkey::openFile() {
    if (QApplication::activeModalWidget() != nullptr)
        return;
    const QString file = anyFile();
    note(QStringLiteral("open %1").arg(QFileInfo(file).fileName()));
    m_station->window.files().open(file);
}

void Monkey::changeLook() {
    note(QStringLiteral("look"));
    if (oneIn(2)) {
        m_station->appearance.setTheme(oneIn(2) ? Theme::dark : Theme::light);
        return;
    }
    const auto& all = languages();
    m_station->appearance.setLanguage(
        all[static_cast<std::size_t>(below(static_cast<int>(all.size())))].code);
}

void Monkey::resize() {
    const QSize size(kSmallestWindow + below(kLargestWindow.width() - kSmallestWindow),
                     kSmallestWindow + below(kLargestWindow.height() - kSmallestWindow));
    note(QStringLiteral("resize %1 %2").arg(size.width()).arg(size.height()));
    m_station->window.resize(size);
}

void Monkey::wait() {
    QTest::qWait(below(200));
}

/// Called by the timer, also while a dialog or a menu runs its own event loop.
void Monkey::workWhatIsOnTop() {
    QWidget* top = QApplication::activePopupWidget();
    if (top == nullptr)
        top = QApplication::activeModalWidget();
    if (top == nullptr) {
        m_patience = kMostOnTop;
        return;
    }
    if (--m_patience < 0) {
        note(QStringLiteral("close %1").arg(named(*top)));
        top->close();
        return;
    }
    if (auto* files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget()))
        workFileDialog(*files);
    else if (oneIn(2))
        click();
    else
        pressKeys();
}

/// Keys and clicks could select any file of this machine, so only files of the test's folder are selected
/// here.
void Monkey::workFileDialog(QFileDialog& dialog) {
    if (oneIn(3)) {
        note(QStringLiteral("reject file dialog"));
        dialog.reject();
        return;
    }
    if (auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit")))
        name->setText(oneIn(2) ? anyFile() : m_folder + QStringLiteral("/saved-%1").arg(below(5)));
    note(QStringLiteral("accept file dialog"));
    QMetaObject::invokeMethod(&dialog, "accept", Qt::QueuedConnection);
}

} // namespace proveout
