// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export_dialog.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include <QFileDialog>
#include <QFileInfo>

#include "ui/diagnostic_text.h"
#include "ui/file_paths.h"

namespace proveout {

namespace {

struct MeshFilter {
    const FileFormat* format = nullptr;
    QString text; ///< "STL, binary (*.stl)"
};

std::vector<MeshFilter> meshFilters() {
    std::vector<MeshFilter> filters;
    for (const FileFormat& format : fileFormats()) {
        if (format.meshWriter() == nullptr)
            continue;
        QStringList patterns;
        for (const char* extension : format.extensions)
            patterns += QLatin1Char('*') + QLatin1String(extension);
        filters.push_back({&format, QStringLiteral("%1 (%2)").arg(coreText(format.label),
                                                                  patterns.join(QLatin1Char(' ')))});
    }
    return filters;
}

const FileFormat* formatOf(const std::vector<MeshFilter>& filters, const QString& text) {
    const auto found =
        std::ranges::find_if(filters, [&text](const MeshFilter& filter) { return filter.text == text; });
    return found == filters.end() ? filters.front().format : found->format;
}

/// Whether files of the format may end as this one does.
bool endsAs(const QString& file, const FileFormat& format) {
    return std::ranges::any_of(format.extensions, [&file](const char* extension) {
        return file.endsWith(QLatin1String(extension), Qt::CaseInsensitive);
    });
}

/// Without the dot.
QString standardEnding(const FileFormat& format) {
    return QString::fromLatin1(format.extensions.front() + 1);
}

/// The name with the ending of another mesh format; other endings are the user's own.
QString withEndingOf(const QString& file, const FileFormat& format) {
    if (!meshFormatOf(toPath(file)) || endsAs(file, format))
        return file;
    const QFileInfo name(file);
    return name.dir().filePath(name.completeBaseName() + QLatin1Char('.') + standardEnding(format));
}

} // namespace

std::optional<ExportTarget> askForExport(QWidget& parent, const QString& title, const QString& proposal) {
    const std::vector<MeshFilter> filters = meshFilters();
    QStringList texts;
    for (const MeshFilter& filter : filters)
        texts += filter.text;
    QFileDialog dialog(&parent, title);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    dialog.setNameFilters(texts);
    // The dialog itself completes a name without an ending, so that it asks before it replaces that file.
    dialog.setDefaultSuffix(standardEnding(*filters.front().format));
    dialog.selectFile(proposal + QLatin1Char('.') + standardEnding(*filters.front().format));
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& text) {
        const FileFormat& format = *formatOf(filters, text);
        dialog.setDefaultSuffix(standardEnding(format));
        dialog.selectFile(withEndingOf(dialog.selectedFiles().value(0), format));
    });
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    const QString file = dialog.selectedFiles().value(0);
    const FileFormat* chosen = formatOf(filters, dialog.selectedNameFilter());
    const auto named = meshFormatOf(toPath(file));
    return ExportTarget{file, named && !endsAs(file, *chosen) ? *named : chosen};
}

} // namespace proveout
