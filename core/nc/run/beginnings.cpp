// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/beginnings.h"

#include "core/nc/program/reporter.h"
#include "core/nc/text/messages.h"

namespace proveout {

void Beginnings::publish(const Program& soFar, std::uint32_t line, std::size_t sourceBlocks) {
    constexpr std::size_t kAgain = 4; // factor to the next publication
    m_next = soFar.motionCount() * kAgain;
    auto program = std::make_shared<Program>(soFar, soFar.extent());
    Reporter reporter(*program, m_file, 0);
    reporter.beginLine(line);
    reporter.reportInAnyCase(nc_message::kStillReading, 1, 0);
    program->setSourceBlockCount(sourceBlocks);
    m_publish(program);
}

} // namespace proveout
