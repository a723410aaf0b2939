// SPDX-License-Identifier: GPL-3.0-or-later
// What panels made of forms have in common.
#pragma once

class QLabel;
class QWidget;

namespace proveout {

/// A bold label over a section, owned by `parent`; the caller sets its text.
[[nodiscard]] QLabel* sectionLabel(QWidget* parent);

/// A label whose sentence wraps at any width, so that it never widens its panel. Owned by `parent`.
[[nodiscard]] QLabel* wrappedLabel(QWidget* parent);

/// Fills `panel`, which has no layout yet, with `content`, scrolled where it is too high. There is no
/// horizontal bar: the panel is never narrower than its content. The panel takes ownership.
void fillScrolled(QWidget& panel, QWidget* content);

} // namespace proveout
