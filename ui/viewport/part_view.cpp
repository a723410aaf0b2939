// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/part_view.h"

#include <utility>

#include <QLocale>

#include "ui/session/session.h"

namespace proveout {

namespace {

constexpr int kTenths = 10;

/// Whether tiles of the frame are others than those that were compared.
bool isOfAnother(const Frame& frame, const Deviation& deviation) {
    if (!deviation.isOn(frame.zmap))
        return true;
    for (std::size_t index = 0; index < frame.zmap.tileCount(); ++index)
        if (frame.zmap.tile(index) != deviation.stock().tile(index))
            return true;
    return false;
}

} // namespace

PartView::PartView(Session& session, const SceneOptions& options, QObject* parent)
    : QObject(parent), m_session(session), m_options(options) {
    connect(&session.job(), &JobHub::partChanged, this, &PartView::changed);
    connect(&session.part(), &PartHub::partChanged, this, &PartView::changed);
    connect(&session.part(), &PartHub::changed, this, &PartView::followHub);
}

bool PartView::isAvailable() const {
    return m_session.job().part().has_value();
}

void PartView::followOptions() {
    m_session.part().setOn(*this, m_options.deviation);
}

void PartView::followHub() {
    const PartHub& hub = m_session.part();
    Shown shown{hub.comparison(), {}, !hub.placement().empty()};
    if (hub.progress())
        shown.progress = static_cast<int>(*hub.progress() * kTenths);
    if (std::exchange(m_shown, shown) != shown)
        emit changed();
}

std::shared_ptr<const DesignPart> PartView::part() const {
    return m_options.part ? m_session.part().contents().part : nullptr;
}

std::shared_ptr<const PartComparison> PartView::comparison() const {
    return m_options.deviation ? m_session.part().comparison() : nullptr;
}

Box3 PartView::bounds() const {
    const auto shown = part();
    return shown ? shown->box() : Box3();
}

std::optional<DeviationLegend> PartView::legend(const Frame& frame, Colouring colouring) const {
    if (!m_options.deviation || !isAvailable())
        return std::nullopt;
    const auto known = comparison();
    return DeviationLegend{known ? known->tolerance : m_session.job().part()->tolerance,
                           noteOn(frame, colouring)};
}

QString PartView::noteOn(const Frame& frame, Colouring colouring) const {
    const PartHub& hub = m_session.part();
    if (hub.isReading())
        return tr("The part is being read.");
    if (hub.contents().part == nullptr)
        return tr("The part cannot be used; see Problems.");
    if (colouring == Colouring::tooLarge)
        return tr("Not enough graphics memory for these colours.");
    if (hub.progress())
        return tr("Comparing: %1 %").arg(100 / kTenths * m_shown.progress.value_or(0));
    const auto known = hub.comparison();
    if (known == nullptr && frame.atRest)
        return tr("The stock cannot be compared.");
    if (known == nullptr || isOfAnother(frame, known->deviation))
        return tr("New cuts are compared when playback stops.");
    return {};
}

} // namespace proveout
