// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/export_dialog.h"

#include <algorithm>
#include <vector>

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "ui/document/file_paths.h"
#include "ui/look/diagnostic_text.h"

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
        filters.push_back({&format, formatFilter(format)});
    }
    return filters;
}

const FileFormat* formatOf(const std::vector<MeshFilter>& filters, const QString& text) {
    const auto found =
        std::ranges::find_if(filters, [&text](const MeshFilter& filter) { return filter.text == text; });
    return found == filters.end() ? filters.front().format : found->format;
}

/// Whether the file name ends in an extension of the format.
bool endsAs(const QString& file, const FileFormat& format) {
    return std::ranges::any_of(format.extensions, [&file](const char* extension) {
        return file.endsWith(QLatin1String(extension), Qt::CaseInsensitive);
    });
}

/// The first extension of the format, without the dot.
QString defaultExtension(const FileFormat& format) {
    return QString::fromLatin1(format.extensions.front() + 1);
}

/// The name with the extension of the format, which replaces that of another mesh format.
QString withEndingOf(const QString& file, const FileFormat& format) {
    if (endsAs(file, format))
        return file;
    const QFileInfo name(file);
    const bool ofAnother = meshFormatOf(toPath(file)).has_value() || file.endsWith(QLatin1Char('.'));
    return name.dir().filePath((ofAnother ? name.completeBaseName() : name.fileName()) + QLatin1Char('.') +
                               defaultExtension(format));
}

/// The file to write for the typed name and the chosen filter. An extension that does not belong to a mesh
/// format is part of the name: "bracket 1.5" is allowed, and a mesh never overwrites a program.
ExportTarget targetOf(const QString& typed, const FileFormat& chosen) {
    const auto named = meshFormatOf(toPath(typed));
    if (named && !endsAs(typed, chosen))
        return {typed, *named};
    return {withEndingOf(typed, chosen), &chosen};
}

bool mayReplace(QWidget& dialog, const QString& file) {
    QMessageBox question(QMessageBox::Warning, dialog.windowTitle(),
                         QCoreApplication::translate("Export", "%1 already exists. Replace it?")
                             .arg(QFileInfo(file).fileName()),
                         QMessageBox::Yes | QMessageBox::No, &dialog);
    question.setTextFormat(Qt::PlainText); // the name comes from the user
    question.setDefaultButton(QMessageBox::No);
    return question.exec() == QMessageBox::Yes;
}

} // namespace

QString formatPatterns(const FileFormat& format) {
    QStringList patterns;
    for (const char* extension : format.extensions)
        patterns += QLatin1Char('*') + QLatin1String(extension);
    return patterns.join(QLatin1Char(' '));
}

QString formatFilter(const FileFormat& format) {
    return QStringLiteral("%1 (%2)").arg(coreText(format.label), formatPatterns(format));
}

std::optional<ExportTarget> askForExport(QWidget& parent, const QString& title, const QString& proposal) {
    const std::vector<MeshFilter> filters = meshFilters();
    QStringList texts;
    for (const MeshFilter& filter : filters)
        texts += filter.text;
    QFileDialog dialog(&parent, title);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    dialog.setOption(QFileDialog::DontConfirmOverwrite); // asked below, for the completed name
    dialog.setNameFilters(texts);
    dialog.selectFile(proposal + QLatin1Char('.') + defaultExtension(*filters.front().format));
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& text) {
        const QString typed = dialog.selectedFiles().value(0);
        if (!QFileInfo(typed).isDir()) // a folder means that no name was typed
            dialog.selectFile(withEndingOf(typed, *formatOf(filters, text)));
    });
    while (dialog.exec() == QDialog::Accepted) {
        const ExportTarget target =
            targetOf(dialog.selectedFiles().value(0), *formatOf(filters, dialog.selectedNameFilter()));
        if (!QFileInfo::exists(target.file) || mayReplace(dialog, target.file))
            return target;
    }
    return std::nullopt;
}

} // namespace proveout
