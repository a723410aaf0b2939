// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/kept_breakpoints.h"

#include <algorithm>

#include <QSettings>

#include "ui/document/file_paths.h"

namespace proveout {

namespace {

const QString kGroup = QStringLiteral("breakpoints");
const QString kFileKey = QStringLiteral("file");
const QString kListKey = QStringLiteral("list");

struct OfFile {
    QString file;
    QStringList texts;
};

std::vector<OfFile> readAll() {
    QSettings settings;
    std::vector<OfFile> all;
    const int count = std::min(settings.beginReadArray(kGroup), KeptBreakpoints::kMostFiles);
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        all.push_back({settings.value(kFileKey).toString(), settings.value(kListKey).toStringList()});
    }
    settings.endArray();
    return all;
}

void writeAll(const std::vector<OfFile>& all) {
    QSettings settings;
    settings.remove(kGroup);
    settings.beginWriteArray(kGroup, static_cast<int>(all.size()));
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        settings.setArrayIndex(i);
        settings.setValue(kFileKey, all[static_cast<std::size_t>(i)].file);
        settings.setValue(kListKey, all[static_cast<std::size_t>(i)].texts);
    }
    settings.endArray();
}

} // namespace

QStringList KeptBreakpoints::written(const std::vector<Breakpoint>& breakpoints) {
    QStringList texts;
    for (const Breakpoint& breakpoint : breakpoints) {
        texts << QStringLiteral("%1 %2 %3")
                     .arg(QLatin1String(rowOf(breakpoint.kind).key),
                          breakpoint.enabled ? QStringLiteral("on") : QStringLiteral("off"),
                          QString::fromStdString(valueText(breakpoint)));
    }
    return texts;
}

std::vector<Breakpoint> KeptBreakpoints::read(const QStringList& texts) {
    std::vector<Breakpoint> breakpoints;
    for (const QString& text : texts) {
        const QString key = text.section(u' ', 0, 0);
        const QString value = text.section(u' ', 2);
        const auto row = std::ranges::find_if(
            breakpointRows(), [&](const BreakpointRow& each) { return key == QLatin1String(each.key); });
        if (row == breakpointRows().end() || breakpoints.size() == Breakpoints::kMost)
            continue;
        Breakpoint breakpoint;
        breakpoint.kind = row->kind;
        breakpoint.enabled = text.section(u' ', 1, 1) != QLatin1String("off");
        if (row->value == BreakpointValue::line)
            breakpoint.line = value.toUInt();
        if (row->value == BreakpointValue::height)
            breakpoint.z = value.toDouble();
        if (row->value == BreakpointValue::condition)
            breakpoint.condition = value.toStdString();
        breakpoints.push_back(std::move(breakpoint));
    }
    return breakpoints;
}

KeptBreakpoints::KeptBreakpoints(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    connect(&session.document(), &DocumentHub::textReplaced, this, &KeptBreakpoints::textReplaced);
    connect(&session.document(), &DocumentHub::changed, this, &KeptBreakpoints::moveToNewName);
    connect(&session.breakpoints(), &BreakpointList::changed, this, &KeptBreakpoints::keep);
    textReplaced();
}

/// Another file has its own breakpoints; a file that was read again keeps the existing ones.
void KeptBreakpoints::textReplaced() {
    const QString file = toQString(m_session.document().text().path);
    if (!file.isEmpty() && file == m_file)
        return;
    m_file = file;
    const std::vector<OfFile> all = readAll();
    const auto known = std::ranges::find(all, file, &OfFile::file);
    m_session.breakpoints().set(known == all.end() ? std::vector<Breakpoint>() : read(known->texts));
}

/// A text that is saved under another name keeps its breakpoints.
void KeptBreakpoints::moveToNewName() {
    const QString file = toQString(m_session.document().text().path);
    if (file == m_file)
        return;
    m_file = file;
    keep();
}

void KeptBreakpoints::keep() {
    if (m_file.isEmpty())
        return;
    std::vector<OfFile> all = readAll();
    std::erase_if(all, [this](const OfFile& kept) { return kept.file == m_file; });
    if (!m_session.breakpoints().all().empty())
        all.insert(all.begin(), {m_file, written(m_session.breakpoints().all())});
    all.resize(std::min<std::size_t>(all.size(), kMostFiles));
    writeAll(all);
}

} // namespace proveout
