// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/study_command.h"
#include "core/study/chart.h"
#include "core/study/sweep.h"

namespace proveout::cli {

/// The files of a study, in one folder.
class StudyFiles {
public:
    StudyFiles(std::filesystem::path folder, const StudyEquipment& equipment)
        : m_folder(std::move(folder)), m_equipment(equipment) {}

    /// Creates the folder if it does not exist.
    [[nodiscard]] Result<void> prepare() const;
    /// Writes ID.csv and ID.svg, and ID.png if this binary can draw it.
    [[nodiscard]] Result<void> write(const Chart& chart);
    /// Writes NAME.csv with one row per run.
    [[nodiscard]] Result<void> write(const std::string& name, std::span<const SweptPoint> points);
    /// The names of the written files, in sequence.
    [[nodiscard]] const std::vector<std::string>& names() const { return m_names; }

private:
    [[nodiscard]] Result<void> writeText(const std::string& name, const std::string& text);

    std::filesystem::path m_folder;
    const StudyEquipment& m_equipment;
    std::vector<std::string> m_names;
};

} // namespace proveout::cli
