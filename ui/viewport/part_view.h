// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QObject>

#include "core/simulation/run/frame.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/surface_renderer.h"
#include "ui/session/part_hub.h"
#include "ui/viewport/hud.h"

namespace proveout {

class Session;

/// What the view shows of the design part: the part itself, and how the stock deviates from it. Stocks are
/// compared while the view shows that. Thread: UI.
class PartView final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object; `options` are read on every call.
    PartView(Session& session, const SceneOptions& options, QObject* parent);

    /// Whether the job has a part.
    [[nodiscard]] bool isAvailable() const;
    /// The options have changed.
    void followOptions();
    /// Null: none is shown, or it is not known yet.
    [[nodiscard]] std::shared_ptr<const DesignPart> part() const;
    [[nodiscard]] std::shared_ptr<const PartComparison> comparison() const;
    /// Of the part that is shown; empty if none is.
    [[nodiscard]] Box3 bounds() const;
    /// For the frame in the view, if the stock is coloured.
    [[nodiscard]] std::optional<DeviationLegend> legend(const Frame& frame, Colouring colouring) const;

signals:
    /// Whatever this class returns.
    void changed();

private:
    /// What the view would show differently.
    struct Shown {
        std::shared_ptr<const PartComparison> comparison;
        std::optional<int> progress; ///< in tenths: every image takes time
        bool isRefused = false;

        friend bool operator==(const Shown&, const Shown&) = default;
    };

    void followHub();
    [[nodiscard]] QString noteOn(const Frame& frame, Colouring colouring) const;

    Session& m_session;
    const SceneOptions& m_options;
    Shown m_shown;
};

} // namespace proveout
