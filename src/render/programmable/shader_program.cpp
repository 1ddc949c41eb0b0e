#include "render/programmable/shader_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/text/input_text.h"
#include "base/text/translation.h"
#include "render/context/gl.h"
#include "render/programmable/numbers/vertex_attributes.h"

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
    throw ShaderRefused(tr("the driver refuses {}: {}", what, log.substr(0, log.find('\n'))),
                        fmt::format("{}\n{}\nfor these effects:\n{}", log, source, describe(effects)));
}

// ---- Too many lights ----

// The numbers in uniforms of a shader: of arrays, which have an element for each light of a kind, and of all others.
struct UniformNumbers {
    struct Array {
        std::string light;  // "u_light0"
        long length = 0, numbers = 0;
    };
    std::vector<Array> arrays;
    long others = 0;

    // With arrays of at most this length.
    long with(long longest) const {
        long sum = others;
        for (const Array& array : arrays) sum += std::min(array.length, longest) * array.numbers;
        return sum;
    }
};

UniformNumbers numbers_of_uniforms(const std::string& source) {
    UniformNumbers found;
    InputText lines(source);
    for (std::string line; std::getline(lines, line);) {
        InputText words(line);
        std::string word, type, name;
        if (!(words >> word >> type >> name) || word != "uniform") continue;
        const long numbers = type == "mat4" ? 16 : type == "mat3" ? 9 : type.starts_with("vec") ? type.back() - '0' : 1;
        const std::size_t bracket = name.find('[');
        const long length = bracket == name.npos ? 1 : std::strtol(name.c_str() + bracket + 1, nullptr, 10);
        if (name.starts_with("u_light") && length > 1)
            found.arrays.push_back({name.substr(0, name.find('_', 2)), length, numbers});
        else
            found.others += length * numbers;
    }
    return found;
}

// Throws ShaderRefused if a shader's lights need more uniforms than the driver has. Its own message does not speak of lights.
void check_lights_fit(const std::string& source, GLenum limit_name) {
    GLint limit = 0;
    glGetIntegerv(limit_name, &limit);
    const UniformNumbers numbers = numbers_of_uniforms(source);
    long longest = 0;
    for (const UniformNumbers::Array& array : numbers.arrays) longest = std::max(longest, array.length);
    if (longest == 0 || numbers.with(longest) <= limit) return;
    while (longest > 1 && numbers.with(longest) > limit) longest /= 2;  // their lengths are powers of two
    long fitting = 0;
    std::set<std::string> kinds;
    for (const UniformNumbers::Array& array : numbers.arrays)
        if (kinds.insert(array.light).second) fitting += std::min(array.length, longest);
    throw ShaderRefused(tr("a draw has more lights than the {} that this driver can have in a shader", fitting), "");
}

GLuint start_compiling(GLenum type, const std::string& source) {
    const GLuint shader = glCreateShader(type);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    return shader;
}

void check_compiled(GLuint shader, const char* what, const std::string& source, const EffectSet& effects) {
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) refuse(what, log_of(shader, glGetShaderiv, glGetShaderInfoLog), numbered(source), effects);
}

bool compiles_in_parallel() {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* name =
            reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));  // NOLINT
        if (name && std::string_view(name) == "GL_KHR_parallel_shader_compile") return true;
    }
    return false;
}

}  // namespace

ShaderProgram::ShaderProgram(ShaderSource source, EffectSet effects)
    : source_(std::move(source)), effects_(std::move(effects)) {
    vertex_ = start_compiling(GL_VERTEX_SHADER, source_.vertex);
    fragment_ = start_compiling(GL_FRAGMENT_SHADER, source_.fragment);
    program_ = glCreateProgram();
    glAttachShader(program_, vertex_);
    glAttachShader(program_, fragment_);
    GLuint index = 0;
    for (const Attribute& attribute : attributes(effects_))
        glBindAttribLocation(program_, index++, attribute.name.c_str());
    glLinkProgram(program_);
}

ShaderProgram::~ShaderProgram() {
    for (const GLuint shader : {vertex_, fragment_}) glDeleteShader(shader);
    glDeleteProgram(program_);
}

bool ShaderProgram::is_ready() const {
    if (vertex_ == 0 || !compiles_in_parallel()) return true;
    GLint complete = GL_TRUE;
    glGetProgramiv(program_, GL_COMPLETION_STATUS_KHR, &complete);
    return complete == GL_TRUE;
}

void ShaderProgram::link() {
    check_compiled(vertex_, tr("a vertex shader"), source_.vertex, effects_);
    check_compiled(fragment_, tr("a fragment shader"), source_.fragment, effects_);
    GLint linked = GL_FALSE;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (!linked) {
        check_lights_fit(source_.vertex, GL_MAX_VERTEX_UNIFORM_COMPONENTS);
        check_lights_fit(source_.fragment, GL_MAX_FRAGMENT_UNIFORM_COMPONENTS);
        refuse(tr("a program"), log_of(program_, glGetProgramiv, glGetProgramInfoLog),
               numbered(source_.vertex) + "\n" + numbered(source_.fragment), effects_);
    }
    for (GLuint* shader : {&vertex_, &fragment_}) glDeleteShader(std::exchange(*shader, 0));
    source_ = {};
    effects_ = {};

    GLint count = 0;
    glGetProgramiv(program_, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        std::array<char, 128> name{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program_, static_cast<GLuint>(i), name.size(), nullptr, &size, &type, name.data());
        std::string text = name.data();
        if (type == GL_SAMPLER_1D || type == GL_SAMPLER_2D || type == GL_SAMPLER_3D || type == GL_SAMPLER_CUBE ||
            type == GL_SAMPLER_1D_SHADOW || type == GL_SAMPLER_2D_SHADOW) {
            // "u_texture3" reads texture unit 3; u_texture keeps its initial value, unit 0.
            const char number = text.back();
            if (number < '1' || number > '9') continue;
            glUseProgram(program_);
            glUniform1i(glGetUniformLocation(program_, name.data()), number - '0');
            continue;
        }
        text.resize(std::min(text.find('['), text.size()));  // "u_light3_position_eye[0]"
        slots_.push_back({.name = std::move(text),
                          .location = glGetUniformLocation(program_, name.data()),
                          .type = type,
                          .length = size});
    }
}

void ShaderProgram::make_current() {
    if (vertex_ != 0) link();
    glUseProgram(program_);
}

void ShaderProgram::use(const Uniforms& uniforms) {
    make_current();
    for (Slot& slot : slots_) {
        if (slot.place >= uniforms.size() || uniforms[slot.place].name != slot.name) {
            const auto found = uniforms.find(slot.name);
            if (!found) throw std::logic_error(fmt::format("no value for the uniform {}", slot.name));
            slot.place = *found;
        }
        const std::span<const float> floats_given = uniforms[slot.place].values;
        if (!slot.set.empty() && are_same(slot.set, floats_given)) continue;
        slot.set.assign(floats_given.begin(), floats_given.end());
        const float* values = floats_given.data();
        const auto given = [&](int floats) {
            return std::min(slot.length, static_cast<GLsizei>(floats_given.size()) / floats);
        };
        switch (slot.type) {
            case GL_INT: {
                if (given(1) == 1) {
                    glUniform1i(slot.location, static_cast<GLint>(*values));
                    break;
                }
                const std::vector<GLint> whole(values, values + given(1));
                glUniform1iv(slot.location, given(1), whole.data());
                break;
            }
            case GL_FLOAT: glUniform1fv(slot.location, given(1), values); break;
            case GL_FLOAT_VEC2: glUniform2fv(slot.location, given(2), values); break;
            case GL_FLOAT_VEC3: glUniform3fv(slot.location, given(3), values); break;
            case GL_FLOAT_VEC4: glUniform4fv(slot.location, given(4), values); break;
            case GL_FLOAT_MAT3: glUniformMatrix3fv(slot.location, given(9), GL_FALSE, values); break;
            case GL_FLOAT_MAT4: glUniformMatrix4fv(slot.location, 1, GL_FALSE, values); break;
            default: throw std::logic_error(fmt::format("the uniform {} has an unsupported type", slot.name));
        }
    }
}

}  // namespace twinlight::programmable
