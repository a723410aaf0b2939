// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/shader_program.h"

#include <QFile>

// A linker drops the resources of a static library unless they are referenced; the macro must be used outside
// of namespaces.
static void keepShaders() {
    Q_INIT_RESOURCE(shaders);
}

namespace proveout {
namespace {

QByteArray preamble(const ShaderFiles& files) {
    QByteArray text = "#version 330 core\n";
    for (const char* name : files.defines)
        text += QByteArray("#define ") + name + "\n";
    return text;
}

QByteArray source(const char* name) {
    keepShaders();
    QFile file(QStringLiteral(":/shaders/") + QLatin1String(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() + "\n" : QByteArray();
}

QByteArray joined(const QList<const char*>& names) {
    QByteArray text;
    for (const char* name : names)
        text += source(name);
    return text;
}

} // namespace

ShaderProgram::ShaderProgram(const ShaderFiles& files) {
    const QByteArray head = preamble(files);
    m_valid = m_program.addShaderFromSourceCode(QOpenGLShader::Vertex, head + joined(files.vertex)) &&
              (files.geometry == nullptr ||
               m_program.addShaderFromSourceCode(QOpenGLShader::Geometry, head + source(files.geometry))) &&
              m_program.addShaderFromSourceCode(QOpenGLShader::Fragment, head + joined(files.fragment)) &&
              m_program.link();
    if (!m_valid)
        qCritical("Shader %s: %s", files.vertex.last(), qPrintable(m_program.log()));
}

} // namespace proveout
