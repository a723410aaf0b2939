// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <QOpenGLFunctions_3_3_Core>

namespace proveout {

/// The functions of OpenGL 3.3 core, the version that the renderer requires and does not exceed.
using Gl = QOpenGLFunctions_3_3_Core;

/// The functions of the current context; null if there is none or its version is below 3.3. Owned by the
/// context.
[[nodiscard]] Gl* currentGl();

/// Drops the errors of earlier calls, so that the next one is that of the calls that follow.
void forgetErrors(Gl& gl);

/// Creates a texture unless it exists, and binds it: one level, edges extended, `filter` in both directions.
void bindTexture(Gl& gl, GLenum target, GLuint& texture, GLint filter);

/// An offset in the bound buffer, in bytes. OpenGL expects it as a pointer, because its interface is older
/// than buffers.
[[nodiscard]] inline const void* bufferPlace(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes); // NOLINT(performance-no-int-to-ptr)
}

/// Whether this machine can provide a widget with an OpenGL 3.3 core context, and by which driver.
struct GlSupport {
    bool usable = false;
    bool software = false; ///< a software rasteriser on the CPU: no multisampling, few repaints
    QString renderer;      ///< the name that the driver reports
    QString reason;        ///< if not usable: one translated sentence
};

/// Creates a context to find out; needs a QGuiApplication. Thread: UI.
[[nodiscard]] GlSupport probeGl();

/// Whether a renderer string names a software rasteriser.
[[nodiscard]] bool isSoftwareRenderer(const QString& renderer);

} // namespace proveout
