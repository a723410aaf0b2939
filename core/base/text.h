// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Marks a user-visible string of the core, so that the translation tools find it. The core itself never
// translates: it hands out the English text, and the workstation looks the translation up under the same
// context. `lupdate` reads this macro as an alias of QT_TRANSLATE_NOOP.
#define PROVEOUT_TEXT(context, text) text
