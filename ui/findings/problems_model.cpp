// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings/problems_model.h"

#include <utility>

#include <QGuiApplication>
#include <QLocale>
#include <QPalette>

#include "core/verification/findings/findings.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/icons.h"
#include "ui/readout/verdict_text.h"

namespace proveout {

ProblemsModel::ProblemsModel(QObject* parent) : QAbstractTableModel(parent) {
    // A different shape for each severity, so that colour is not needed. Created once, because a list
    // requests the icons for each row.
    for (const Severity severity : {Severity::note, Severity::warning, Severity::error, Severity::fault})
        m_icons[static_cast<std::size_t>(severity)] = icon(QLatin1String(name(severity)));
    m_openIcon = icon(QStringLiteral("help"));
    m_acceptedIcon = icon(QStringLiteral("safe"));
}

void ProblemsModel::setProblems(std::vector<CheckFinding> problems, std::vector<NotChecked> notChecked) {
    beginResetModel();
    m_problems = std::move(problems);
    m_notChecked = std::move(notChecked);
    m_current = m_problems.size() + m_notChecked.size();
    endResetModel();
}

void ProblemsModel::setProblems(std::vector<CheckFinding> problems, const std::vector<CheckFinding>& outdated,
                                std::vector<NotChecked> notChecked) {
    beginResetModel();
    m_current = problems.size();
    m_problems = std::move(problems);
    m_problems.insert(m_problems.end(), outdated.begin(), outdated.end());
    m_notChecked = std::move(notChecked);
    endResetModel();
}

const CheckFinding* ProblemsModel::problem(int row) const {
    const auto index = static_cast<std::size_t>(row);
    return index < m_problems.size() ? &m_problems[index] : nullptr;
}

const NotChecked* ProblemsModel::notChecked(int row) const {
    const auto index = static_cast<std::size_t>(row);
    return index < m_problems.size() ? nullptr : &m_notChecked[index - m_problems.size()];
}

int ProblemsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_problems.size() + m_notChecked.size());
}

int ProblemsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumnCount;
}

QString ProblemsModel::waiverText(const Waiver& waiver) {
    return tr("Waived by %1: %2")
        .arg(QString::fromStdString(waiver.owner), QString::fromStdString(waiver.reason));
}

QString ProblemsModel::text(const CheckFinding& problem, int column) {
    const Diagnostic& diagnostic = problem.diagnostic;
    switch (column) {
    case kSeverity:
        return problem.waived ? tr("Waived") : severityName(diagnostic.severity);
    case kLine:
        return diagnostic.where.line > 0 ? QString::number(diagnostic.where.line) : QString();
    case kSentence:
        return sentence(diagnostic);
    case kTool:
        return problem.block > 0 ? QStringLiteral("T%1").arg(problem.tool) : QString();
    case kSize:
        return sizeText(problem, QLocale());
    case kCount:
        return problem.count > 1 ? QLocale().toString(static_cast<qulonglong>(problem.count)) : QString();
    case kHint:
        return problem.waived ? waiverText(*problem.waived) : hint(diagnostic);
    case kId:
        return QLatin1String(diagnostic.id);
    default:
        return {};
    }
}

QString ProblemsModel::text(const NotChecked& entry, int column) {
    switch (column) {
    case kSeverity:
        return entry.accepted ? tr("Accepted") : tr("Not checked");
    case kSentence:
        return coreText(entry.row->title);
    case kHint:
        return entry.accepted ? QString() : tr("Check it yourself; then accept it in the context menu.");
    case kId:
        return QLatin1String(entry.row->id);
    default:
        return {};
    }
}

QVariant ProblemsModel::sortValue(const CheckFinding& problem, int column) {
    switch (column) {
    case kSeverity:
        return problem.waived ? -1 : static_cast<int>(problem.diagnostic.severity);
    case kLine:
        return problem.diagnostic.where.line;
    case kTool:
        return problem.tool;
    case kSize:
        return problem.value;
    case kCount:
        return static_cast<qulonglong>(problem.count);
    default:
        return text(problem, column);
    }
}

/// A row including what its columns have no space for; rich text, because that is wrapped.
QString ProblemsModel::wholeText(const CheckFinding& problem) {
    const Diagnostic& diagnostic = problem.diagnostic;
    QString whole =
        QStringLiteral("<p><b>%1</b></p>").arg(coreText(findingTitle(diagnostic.id)).toHtmlEscaped());
    const QLocale locale;
    const QString repeated =
        problem.count > 1
            ? tr("Lines %1 to %2, %3 times.")
                  .arg(locale.toString(diagnostic.where.line), locale.toString(problem.lastLine),
                       locale.toString(static_cast<qulonglong>(problem.count)))
            : QString();
    const QString size = problem.limit > 0
                             ? tr("Largest value: %1; limit: %2 %3.")
                                   .arg(sizeText(problem, locale), locale.toString(problem.limit, 'g', 4),
                                        QString::fromUtf8(problem.unit))
                             : QString();
    const QString unverified = diagnostic.unverified ? tr("Results after this are unverified.") : QString();
    const QString waived = problem.waived ? waiverText(*problem.waived) : QString();
    for (const QString& part : {sentence(diagnostic), repeated, size, hint(diagnostic), unverified, waived,
                                QString(QLatin1String(diagnostic.id))})
        if (!part.isEmpty())
            whole += QStringLiteral("<p>%1</p>").arg(part.toHtmlEscaped());
    return whole;
}

QString ProblemsModel::wholeText(const NotChecked& entry) {
    QString whole = QStringLiteral("<p><b>%1</b></p>").arg(text(entry, kSeverity).toHtmlEscaped());
    for (const int column : {kSentence, kHint, kId})
        if (const QString part = text(entry, column); !part.isEmpty())
            whole += QStringLiteral("<p>%1</p>").arg(part.toHtmlEscaped());
    return whole;
}

QVariant ProblemsModel::data(const QModelIndex& index, int role) const {
    const CheckFinding* shown = problem(index.row());
    const NotChecked* open = notChecked(index.row());
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole:
        return shown != nullptr ? text(*shown, column) : text(*open, column);
    case kSortRole:
        return shown != nullptr ? sortValue(*shown, column) : QVariant(text(*open, column));
    case Qt::ToolTipRole:
        return (isOutdated(index.row())
                    ? QStringLiteral("<p><i>%1</i></p>").arg(tr("Of the check before the last change"))
                    : QString()) +
               (shown != nullptr ? wholeText(*shown) : wholeText(*open));
    case Qt::ForegroundRole:
        return isOutdated(index.row()) ? QGuiApplication::palette().brush(QPalette::PlaceholderText)
                                       : QVariant();
    case Qt::DecorationRole:
        return column == kSeverity ? QVariant(iconOf(index.row())) : QVariant();
    case Qt::TextAlignmentRole:
        if (column == kLine || column == kSize || column == kCount)
            return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
        return {};
    default:
        return {};
    }
}

QIcon ProblemsModel::iconOf(int row) const {
    const auto plain = [&] {
        if (const CheckFinding* shown = problem(row))
            return shown->waived ? m_acceptedIcon
                                 : m_icons[static_cast<std::size_t>(shown->diagnostic.severity)];
        return notChecked(row)->accepted ? m_acceptedIcon : m_openIcon;
    };
    if (!isOutdated(row))
        return plain();
    constexpr int kPixels = 16;
    return QIcon(plain().pixmap(kPixels, QIcon::Disabled));
}

QVariant ProblemsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case kSeverity:
        return tr("Severity");
    case kLine:
        return tr("Line");
    case kSentence:
        return tr("Problem");
    case kTool:
        return tr("Tool");
    case kSize:
        return tr("Size");
    case kCount:
        return tr("Count");
    case kHint:
        return tr("What to do");
    case kId:
        return tr("Id");
    default:
        return {};
    }
}

} // namespace proveout
