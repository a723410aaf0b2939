// SPDX-License-Identifier: GPL-3.0-or-later
// All messages of the NC library about a program: one row per message, one header per subject.
#pragma once

#include "core/nc/text/code_messages.h"         // IWYU pragma: export
#include "core/nc/text/compensation_messages.h" // IWYU pragma: export
#include "core/nc/text/corner_messages.h"       // IWYU pragma: export
#include "core/nc/text/cycle_messages.h"        // IWYU pragma: export
#include "core/nc/text/expression_messages.h"   // IWYU pragma: export
#include "core/nc/text/feed_messages.h"         // IWYU pragma: export
#include "core/nc/text/flow_messages.h"         // IWYU pragma: export
#include "core/nc/text/foreign_messages.h"      // IWYU pragma: export
#include "core/nc/text/line_messages.h"         // IWYU pragma: export
#include "core/nc/text/lint_messages.h"         // IWYU pragma: export
#include "core/nc/text/load_messages.h"         // IWYU pragma: export
#include "core/nc/text/motion_messages.h"       // IWYU pragma: export
#include "core/nc/text/offset_messages.h"       // IWYU pragma: export
#include "core/nc/text/probe_messages.h"        // IWYU pragma: export
#include "core/nc/text/program_messages.h"      // IWYU pragma: export
#include "core/nc/text/spline_messages.h"       // IWYU pragma: export
