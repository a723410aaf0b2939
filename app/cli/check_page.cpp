// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_page.h"

#include <chrono>
#include <ctime>
#include <fmt/chrono.h>

#include "core/base/atomic_file.h"
#include "core/report/report_page.h"
#include "core/report/report_pictures.h"

namespace proveout::cli {

namespace {

std::string today() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    return fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(now));
}

} // namespace

Result<void> writeReport(const std::string& file, const nlohmann::ordered_json& json,
                         const CheckedProgram& checked) {
    const CheckReport& report = checked.report;
    const ReportPictures pictures =
        report.result ? reportPictures(report.result->stock, report.part.get()) : ReportPictures();
    const std::filesystem::path& program = checked.program.empty() ? checked.input : checked.program;
    const ReportHead head{.title = program.filename().string(),
                          .company = {},
                          .generator = "Proveout " PROVEOUT_VERSION,
                          .date = today()};
    AtomicFile out(file);
    out.write(reportPage(json, head, pictures));
    return out.commit();
}

} // namespace proveout::cli
