// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/contact_hub.h"

#include <utility>

#include "ui/session/document_hub.h"
#include "ui/session/playback_hub.h"
#include "ui/session/program_hub.h"

namespace proveout {

ContactHub::ContactHub(const DocumentHub& document, const ProgramHub& program, PlaybackHub& playback)
    : m_document(document), m_program(program), m_playback(playback) {
    connect(&playback, &PlaybackHub::headSent, this, &ContactHub::clear);
    connect(&program, &ProgramHub::outdated, this, &ContactHub::clear);
    connect(&document, &DocumentHub::textReplaced, this, &ContactHub::clear);
}

std::optional<std::uint32_t> ContactHub::show(const CheckFinding& finding) {
    clear();
    if (!m_program.current() || !m_program.isUpToDate())
        return std::nullopt;
    auto contact = contactOf(finding, *m_program.current(), *m_document.job().setup());
    if (!contact)
        return std::nullopt;
    m_playback.pause();
    m_playback.seek(contact->block + 1);
    m_contact = std::move(contact);
    m_of = m_program.current();
    emit changed();
    return m_of->blockLine(m_contact->block);
}

void ContactHub::clear() {
    m_of.reset();
    if (std::exchange(m_contact, std::nullopt))
        emit changed();
}

const FoundContact* ContactHub::in(const Frame* frame) const {
    const bool isMoment = m_contact && frame != nullptr && frame->program == m_of &&
                          frame->block == m_contact->block + 1 && !frame->playing;
    return isMoment ? &*m_contact : nullptr;
}

} // namespace proveout
