// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readout/tool_actions.h"

#include <algorithm>
#include <cstddef>

#include <QCoreApplication>
#include <QStringList>

#include "core/cutter/shapes.h"
#include "ui/look/diagnostic_text.h"
#include "ui/session/session.h"

namespace proveout {

namespace {

constexpr const char* kDefaultCutter = "flat:d=10";
constexpr std::size_t kListed = 5;

QString text(const char* source) {
    return QCoreApplication::translate("Tools", source);
}

/// The number to define for a missing tool. A program without tool changes runs with the only tool of the
/// table, so T1 is defined for it.
int numberToDefine(const Session& session, int missing) {
    const auto& tools = session.job().setup().tools.tools();
    return missing == 0 && tools.empty() && toolChangeMarks(*session.program().current()).empty() ? 1
                                                                                                  : missing;
}

} // namespace

ToolChoice toolChoice(const Session& session) {
    return session.program().current() ? ToolChoice(*session.program().current(), session.job().setup())
                                       : ToolChoice();
}

std::vector<int> missingTools(const Session& session) {
    std::vector<int> numbers;
    const ToolChoice choice = toolChoice(session);
    for (const MissingTool& tool : choice.missing())
        numbers.push_back(numberToDefine(session, tool.number));
    return numbers;
}

void assumeMissingTools(Session& session) {
    session.job().asOneStep([&session] {
        const Result<Cutter> cutter = parseCutter(kDefaultCutter);
        Setup setup = session.job().setup();
        for (const int number : missingTools(session))
            setup.tools.set(number, cutter.value(), {ToolSource::assumed});
        static_cast<void>(session.job().setSetup(setup)); // tools need no memory check
    });
}

void confirmTools(Session& session) {
    session.job().asOneStep([&session] {
        Setup setup = session.job().setup();
        setup.tools.confirmAll();
        static_cast<void>(session.job().setSetup(setup));
    });
}

QString toolList(const std::vector<int>& numbers) {
    QStringList names;
    for (std::size_t i = 0; i < std::min(numbers.size(), kListed); ++i)
        names << QStringLiteral("T%1").arg(numbers[i]);
    return names.join(QStringLiteral(", ")) + (numbers.size() > kListed ? QStringLiteral(", …") : QString());
}

QString assumedText(const QString& tool) {
    return text(QT_TRANSLATE_NOOP("Tools", "%1 (assumed)")).arg(tool);
}

QString toolText(int number, const ToolChoice& choice, const ToolTable& tools) {
    const int tool = choice.tool(number);
    if (tool == 0 && tools.find(0) == nullptr)
        return text(QT_TRANSLATE_NOOP("Tools", "no tool"));
    const QString name = QStringLiteral("T%1").arg(tool);
    return choice.isAssumed(number) ? assumedText(name) : name;
}

QString cutterText(const Cutter& cutter, const QLocale& locale) {
    const CutterShape* shape = shapeOf(cutter.spec());
    return QStringLiteral("⌀ %1 mm %2")
        .arg(locale.toString(2 * cutter.radius(), 'g', 6),
             shape == nullptr ? QString() : coreText(shape->label));
}

} // namespace proveout
