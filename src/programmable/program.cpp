#include "programmable/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "context/gl.h"
#include "programmable/attributes.h"

namespace twinlight::programmable {
namespace {

std::string numbered(const std::string& source) {
    std::string text;
    int number = 1;
    for (std::size_t at = 0, end; at < source.size(); at = end + 1) {
        end = std::min(source.find('\n', at), source.size());
        text += fmt::format("{:4} {}\n", number++, source.substr(at, end - at));
    }
    return text;
}

std::string log_of(GLuint object, decltype(glGetShaderiv) get, decltype(glGetShaderInfoLog) get_log) {
    GLint length = 0;
    get(object, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    get_log(object, length, nullptr, log.data());
    log.resize(log.find('\0') == log.npos ? log.size() : log.find('\0'));
    return log;
}

[[noreturn]] void refuse(const char* what, const std::string& log, const std::string& source,
                         const EffectSet& effects) {
    throw std::runtime_error(
        fmt::format("the driver refuses {}:\n{}\n{}\nfor these effects:\n{}", what, log, source, describe(effects)));
}

// A shader object that lives as long as its program is being linked.
class Shader {
  public:
    Shader(GLenum type, const std::string& source, const EffectSet& effects) : shader_(glCreateShader(type)) {
        const char* text = source.c_str();
        glShaderSource(shader_, 1, &text, nullptr);
        glCompileShader(shader_);
        GLint compiled = GL_FALSE;
        glGetShaderiv(shader_, GL_COMPILE_STATUS, &compiled);
        if (compiled) return;
        const std::string log = log_of(shader_, glGetShaderiv, glGetShaderInfoLog);
        glDeleteShader(shader_);
        refuse(type == GL_VERTEX_SHADER ? "a vertex shader" : "a fragment shader", log, numbered(source), effects);
    }
    ~Shader() { glDeleteShader(shader_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    GLuint name() const { return shader_; }

  private:
    GLuint shader_;
};

}  // namespace

Program::Program(const EffectSet& effects) {
    const ShaderSource source = assemble(effects);
    const Shader vertex(GL_VERTEX_SHADER, source.vertex, effects);
    const Shader fragment(GL_FRAGMENT_SHADER, source.fragment, effects);
    program_ = glCreateProgram();
    glAttachShader(program_, vertex.name());
    glAttachShader(program_, fragment.name());
    GLuint index = 0;
    for (const Attribute& attribute : attributes(effects))
        glBindAttribLocation(program_, index++, attribute.name.c_str());
    glLinkProgram(program_);
    GLint linked = GL_FALSE;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (!linked) {
        const std::string log = log_of(program_, glGetProgramiv, glGetProgramInfoLog);
        glDeleteProgram(program_);
        refuse("a program", log, numbered(source.vertex) + "\n" + numbered(source.fragment), effects);
    }

    GLint count = 0;
    glGetProgramiv(program_, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        std::array<char, 128> name{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program_, static_cast<GLuint>(i), name.size(), nullptr, &size, &type, name.data());
        if (type == GL_SAMPLER_1D || type == GL_SAMPLER_2D) continue;  // it keeps its initial value, unit 0
        slots_.push_back({name.data(), glGetUniformLocation(program_, name.data())});
    }
}

Program::~Program() { glDeleteProgram(program_); }

void Program::use(const Uniforms& uniforms) const {
    glUseProgram(program_);
    for (const Slot& slot : slots_) {
        const auto found = uniforms.find(slot.name);
        if (found == uniforms.end()) throw std::logic_error(fmt::format("no value for the uniform {}", slot.name));
        const float* values = found->second.data();
        switch (found->second.size()) {
            case 1: glUniform1fv(slot.location, 1, values); break;
            case 3: glUniform3fv(slot.location, 1, values); break;
            case 4: glUniform4fv(slot.location, 1, values); break;
            case 9: glUniformMatrix3fv(slot.location, 1, GL_FALSE, values); break;
            case 16: glUniformMatrix4fv(slot.location, 1, GL_FALSE, values); break;
            default: throw std::logic_error(fmt::format("the uniform {} has an odd size", slot.name));
        }
    }
}

}  // namespace twinlight::programmable
