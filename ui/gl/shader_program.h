// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QByteArray>
#include <QList>
#include <QOpenGLShaderProgram>

#include <glm/glm.hpp>

#include "ui/gl/gl_functions.h"

namespace proveout {

/// The files of one program, as names below `resources/shaders`; those of a stage are joined in the given
/// sequence.
struct ShaderFiles {
    QList<const char*> vertex;
    const char* geometry = nullptr; ///< may be null
    QList<const char*> fragment;
    QList<const char*> defines; ///< preprocessor names, defined in every stage
};

/// A linked program and its uniforms by name. Needs the context in which it was created to be current.
class ShaderProgram {
public:
    /// Compiles and links. A failure is a bug in this application or in the driver: it is logged, and valid()
    /// is false.
    explicit ShaderProgram(const ShaderFiles& files);

    [[nodiscard]] bool valid() const { return m_valid; }
    void bind(Gl& gl) { gl.glUseProgram(m_program.programId()); }

    // For the bound program; names that the program does not use are ignored.
    void set(Gl& gl, const char* name, int value) { gl.glUniform1i(at(name), value); }
    void set(Gl& gl, const char* name, bool value) { gl.glUniform1i(at(name), value ? 1 : 0); }
    void set(Gl& gl, const char* name, float value) { gl.glUniform1f(at(name), value); }
    void set(Gl& gl, const char* name, const glm::ivec2& v) { gl.glUniform2i(at(name), v.x, v.y); }
    void set(Gl& gl, const char* name, const glm::vec2& v) { gl.glUniform2f(at(name), v.x, v.y); }
    void set(Gl& gl, const char* name, const glm::vec3& v) { gl.glUniform3f(at(name), v.x, v.y, v.z); }
    void set(Gl& gl, const char* name, const glm::vec4& v) { gl.glUniform4f(at(name), v.x, v.y, v.z, v.w); }
    void set(Gl& gl, const char* name, const glm::mat4& m) {
        gl.glUniformMatrix4fv(at(name), 1, GL_FALSE, &m[0][0]);
    }

private:
    [[nodiscard]] int at(const char* name) { return m_program.uniformLocation(name); }

    QOpenGLShaderProgram m_program;
    bool m_valid = false;
};

} // namespace proveout
