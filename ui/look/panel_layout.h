// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of panels that consist of forms.
#pragma once

class QLabel;
class QWidget;

namespace proveout {

/// A bold heading of a section, owned by `parent`; the caller sets its text.
[[nodiscard]] QLabel* sectionLabel(QWidget* parent);

/// A label whose text wraps at any width, so that it never widens its panel. Owned by `parent`.
[[nodiscard]] QLabel* wrappedLabel(QWidget* parent);

/// Fills `panel`, which must not have a layout yet, with `content` in a vertical scroll area. There is no
/// horizontal scroll bar, because the panel is never narrower than its content. The panel takes ownership.
void fillScrolled(QWidget& panel, QWidget* content);

} // namespace proveout
