// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings/problems_model.h"

#include "core/verification/findings/findings.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/icons.h"

namespace proveout {

ProblemsModel::ProblemsModel(QObject* parent) : QAbstractTableModel(parent) {
    // A different shape for each severity, so that colour is not needed. Created once, because a list
    // requests the icons for each row.
    for (const Severity severity : {Severity::note, Severity::warning, Severity::error, Severity::fault})
        m_icons[static_cast<std::size_t>(severity)] = icon(QLatin1String(name(severity)));
}

void ProblemsModel::setProblems(const Diagnostics& problems) {
    beginResetModel();
    m_problems = problems;
    endResetModel();
}

int ProblemsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_problems.size());
}

int ProblemsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumnCount;
}

QString ProblemsModel::text(const Diagnostic& problem, int column) {
    switch (column) {
    case kSeverity:
        return severityName(problem.severity);
    case kLine:
        return problem.where.line > 0 ? QString::number(problem.where.line) : QString();
    case kSentence:
        return sentence(problem);
    case kHint:
        return hint(problem);
    case kId:
        return QLatin1String(problem.id);
    default:
        return {};
    }
}

/// A row including what its columns have no space for; rich text, because that is wrapped.
QString ProblemsModel::wholeText(const Diagnostic& problem) {
    QString whole =
        QStringLiteral("<p><b>%1</b></p>").arg(coreText(findingTitle(problem.id)).toHtmlEscaped());
    const QString unverified = problem.unverified ? tr("Results after this are unverified.") : QString();
    for (const QString& part :
         {sentence(problem), hint(problem), unverified, QString(QLatin1String(problem.id))})
        if (!part.isEmpty())
            whole += QStringLiteral("<p>%1</p>").arg(part.toHtmlEscaped());
    return whole;
}

QVariant ProblemsModel::data(const QModelIndex& index, int role) const {
    const Diagnostic& shown = problem(index.row());
    if (role == Qt::DisplayRole)
        return text(shown, index.column());
    if (role == Qt::ToolTipRole)
        return wholeText(shown);
    if (role == Qt::DecorationRole && index.column() == kSeverity)
        return m_icons[static_cast<std::size_t>(shown.severity)];
    if (role == Qt::TextAlignmentRole && index.column() == kLine)
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    return {};
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
    case kHint:
        return tr("What to do");
    case kId:
        return tr("Id");
    default:
        return {};
    }
}

} // namespace proveout
