// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <QObject>

#include "core/simulation/run/frame.h"
#include "core/verification/check/found_contact.h"

namespace proveout {

class DocumentHub;
class PlaybackHub;
class ProgramHub;

/// The contact that the user has chosen among the findings: the views show the tool as it is then, until
/// another block is requested. Thread: the UI thread.
class ContactHub final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object.
    ContactHub(const DocumentHub& document, const ProgramHub& program, PlaybackHub& playback);

    /// Shows the contact of a finding: pauses, and goes to the end of its worst block. Returns the line of
    /// that block; nothing, and shows nothing, if the finding has no contact.
    std::optional<std::uint32_t> show(const CheckFinding& finding);
    void clear();
    [[nodiscard]] bool isShown() const { return m_contact.has_value(); }
    /// The contact; null if there is none, or while the frame is not of its block.
    [[nodiscard]] const FoundContact* in(const Frame* frame) const;

signals:
    void changed();

private:
    const DocumentHub& m_document;
    const ProgramHub& m_program;
    PlaybackHub& m_playback;
    std::optional<FoundContact> m_contact;
    std::shared_ptr<const Program> m_of; ///< the program of the contact
};

} // namespace proveout
