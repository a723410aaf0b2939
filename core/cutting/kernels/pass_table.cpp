// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/cutting/kernels/tile_kernel.h"

namespace proveout {

void PassTable::arrange() {
    const auto rounds = std::stable_partition(m_passes.begin(), m_passes.end(), [](const TilePass& pass) {
        return pass.path == TilePass::Path::straight;
    });
    m_straight = static_cast<std::size_t>(rounds - m_passes.begin());
    m_roundPlanes.resize(m_passes.size() - m_straight);
    m_padded = (m_straight + kWidest - 1) / kWidest * kWidest;
    m_fields.assign(kFields.size() * m_padded, -1.0F);
    for (std::size_t field = 0; field < kFields.size(); ++field) {
        float* values = m_fields.data() + field * m_padded;
        for (std::size_t k = 0; k < m_straight; ++k)
            *values++ = m_passes[k].*kFields[field];
    }
    // Whole vectors are written, wherever the last value is.
    const std::size_t most = m_padded + m_roundPlanes.size() + kWidest;
    for (std::vector<float>* values :
         {&m_candidates.middle, &m_candidates.perColumn, &m_candidates.perRow, &m_candidates.lowest})
        values->resize(std::max(values->size(), most));
    m_candidates.pass.resize(std::max(m_candidates.pass.size(), most));
}

} // namespace proveout
