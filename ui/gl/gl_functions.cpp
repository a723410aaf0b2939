// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/gl_functions.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>

namespace proveout {

Gl* currentGl() {
    QOpenGLContext* context = QOpenGLContext::currentContext();
    if (context == nullptr || context->isOpenGLES() || context->format().version() < std::pair{3, 3})
        return nullptr;
    auto* gl = QOpenGLVersionFunctionsFactory::get<Gl>(context);
    return gl != nullptr && gl->initializeOpenGLFunctions() ? gl : nullptr;
}

void bindTexture(Gl& gl, GLenum target, GLuint& texture, GLint filter) {
    if (texture == 0)
        gl.glGenTextures(1, &texture);
    gl.glBindTexture(target, texture);
    gl.glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    gl.glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
    gl.glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
}

void forgetErrors(Gl& gl) {
    constexpr int kMost = 16; // a lost context reports one for ever
    for (int k = 0; k < kMost && gl.glGetError() != GL_NO_ERROR; ++k) {
    }
}

bool isSoftwareRenderer(const QString& renderer) {
    for (const char* name : {"llvmpipe", "softpipe", "SwiftShader", "Software Rasterizer", "GDI Generic"})
        if (renderer.contains(QLatin1String(name), Qt::CaseInsensitive))
            return true;
    return false;
}

namespace {
GlSupport unusable(const char* reason) {
    return {false, false, {}, QCoreApplication::translate("Viewport", reason)};
}
} // namespace

GlSupport probeGl() {
    // These platforms provide contexts, but a QOpenGLWidget has no surface to draw on there and may crash.
    for (const char* platform : {"offscreen", "minimal", "vnc", "linuxfb"})
        if (QGuiApplication::platformName() == QLatin1String(platform))
            return unusable(QT_TRANSLATE_NOOP(
                "Viewport", "OpenGL is not available on this display; the 3D view is off."));
    QOpenGLContext context;
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    context.setFormat(format);
    QOffscreenSurface surface;
    surface.setFormat(format);
    surface.create();
    if (!context.create() || !context.makeCurrent(&surface))
        return unusable(
            QT_TRANSLATE_NOOP("Viewport", "The OpenGL context could not be created; the 3D view is off."));
    GlSupport support;
    if (Gl* gl = currentGl()) {
        support.usable = true;
        support.renderer = QString::fromLatin1(reinterpret_cast<const char*>(gl->glGetString(GL_RENDERER)));
        support.software = isSoftwareRenderer(support.renderer);
    } else {
        support = unusable(QT_TRANSLATE_NOOP(
            "Viewport", "The graphics driver does not support OpenGL 3.3; the 3D view is off."));
    }
    context.doneCurrent();
    return support;
}

} // namespace proveout
