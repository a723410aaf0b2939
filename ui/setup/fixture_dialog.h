// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/cutting/fixtures/fixture_templates.h"

class QWidget;

namespace proveout {

/// Ask for the sizes of a device in a dialog over the window of `parent`, and call `use` if the user accepts
/// them. They return at once. Thread: UI.
void askForVice(QWidget& parent, const Vice& proposed, std::function<void(const Vice&)> use);
void askForStepClamp(QWidget& parent, const StepClamp& proposed, std::function<void(const StepClamp&)> use);

} // namespace proveout
