// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/study_files.h"

#include <system_error>

#include "core/base/atomic_file.h"
#include "core/study/study_csv.h"
#include "core/study/svg_chart.h"
#include "core/verification/findings/command_line_findings.h"

namespace proveout::cli {

namespace {

constexpr std::uint64_t kLeastBytes = 200'000; ///< for one sweep with its figures

} // namespace

Result<void> StudyFiles::prepare() const {
    std::error_code error;
    std::filesystem::create_directories(m_folder, error);
    if (error)
        return failure(command_line_finding::kFolderUnwritable, {error.message()}, m_folder.string());
    // Tested by opening a file before hours of sweeps, because permissions alone are not sufficient (a full
    // disk, root).
    auto ready = AtomicFile(m_folder / "runs.csv", kLeastBytes).ready();
    if (!ready)
        ready.error().front().file = m_folder.string();
    return ready;
}

Result<void> StudyFiles::write(const Chart& chart) {
    if (auto written = writeText(chart.id + ".csv", chartCsv(chart)); !written)
        return written;
    const std::string svg = svgChart(chart);
    if (auto written = writeText(chart.id + ".svg", svg); !written)
        return written;
    if (!m_equipment.writePicture)
        return {};
    const std::string name = chart.id + ".png";
    m_names.push_back(name);
    return m_equipment.writePicture(m_folder / name, svg);
}

Result<void> StudyFiles::write(const std::string& name, std::span<const SweptPoint> points) {
    return writeText(name + ".csv", sweepCsv(points));
}

Result<void> StudyFiles::writeText(const std::string& name, const std::string& text) {
    m_names.push_back(name);
    return writeFile(m_folder / name, text);
}

} // namespace proveout::cli
