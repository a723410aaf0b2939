// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/cli/command.h"
#include "core/study/draw_cost.h"

namespace proveout::cli {

/// The drawing functions of a binary; the headless binary has none.
struct StudyEquipment {
    /// Creates the renderer whose time is measured, for images of width × height pixels.
    std::function<Result<std::unique_ptr<DrawCost>>(int width, int height)> renderer;
    /// Writes an SVG document as PNG.
    std::function<Result<void>(const std::filesystem::path& file, const std::string& svg)> writePicture;
};

/// `study`: the paper's curves on a program, and the choice of region size and period.
void addStudyCommand(CLI::App& app, ExitCode& exitCode, StudyEquipment equipment);

} // namespace proveout::cli
