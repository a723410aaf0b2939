// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <QOpenGLFunctions_3_3_Core>

namespace proveout {

/// The calls of OpenGL 3.3 core: the floor that the renderer asks for and stays on.
using Gl = QOpenGLFunctions_3_3_Core;

/// Those of the current context; null where there is none or it offers less than 3.3. Owned by the context.
[[nodiscard]] Gl* currentGl();

/// A place in the bound buffer, in bytes, as OpenGL wants it told: as a pointer, since buffers came after
/// pointers.
[[nodiscard]] inline const void* bufferPlace(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes); // NOLINT(performance-no-int-to-ptr)
}

/// Whether this machine can give a widget a context of OpenGL 3.3 core, and what drives it.
struct GlSupport {
    bool usable = false;
    bool software = false; ///< a rasteriser on the processor: no multisampling, sparse repainting
    QString renderer;      ///< the driver's name for itself
    QString reason;        ///< where not usable: one translated sentence
};

/// Tries it with a context of its own; needs a QGuiApplication. Thread: UI.
[[nodiscard]] GlSupport probeGl();

/// Whether a renderer string names a software rasteriser.
[[nodiscard]] bool isSoftwareRenderer(const QString& renderer);

} // namespace proveout
