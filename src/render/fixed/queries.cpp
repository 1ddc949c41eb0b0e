#include "render/fixed/queries.h"

#include <array>

#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "scene/state/answers.h"

namespace twinlight::fixed {

namespace {

// Some names of drivers have hundreds of values (GL_COMPRESSED_TEXTURE_FORMATS).
constexpr std::size_t kMostValues = 4096;

// The names of objects are the driver's; offscreen, colour buffers have other names than in a window.
bool names_objects(const Command& query) {
    if (query.sig().parameters.front().name != "pname") return false;
    switch (query.enumerant(0)) {
        case GL_TEXTURE_BINDING_1D:
        case GL_TEXTURE_BINDING_2D:
        case GL_TEXTURE_BINDING_3D:
        case GL_TEXTURE_BINDING_CUBE_MAP:
        case GL_ARRAY_BUFFER_BINDING:
        case GL_ELEMENT_ARRAY_BUFFER_BINDING:
        case GL_PIXEL_PACK_BUFFER_BINDING:
        case GL_PIXEL_UNPACK_BUFFER_BINDING:
        case GL_VERTEX_ARRAY_BUFFER_BINDING:
        case GL_NORMAL_ARRAY_BUFFER_BINDING:
        case GL_COLOR_ARRAY_BUFFER_BINDING:
        case GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING:
        case GL_EDGE_FLAG_ARRAY_BUFFER_BINDING:
        case GL_FRAMEBUFFER_BINDING:
        case GL_READ_FRAMEBUFFER_BINDING:
        case GL_RENDERBUFFER_BINDING:
        case GL_DRAW_BUFFER:
        case GL_READ_BUFFER: return true;
        default: return false;
    }
}

template <class Value, class Function>
std::vector<double> asked(std::size_t count, const Function& get) {
    std::vector<Value> values(kMostValues);
    while (glGetError() != GL_NO_ERROR) {
    }
    get(values.data());
    if (glGetError() != GL_NO_ERROR) return {};
    return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count)};
}

std::vector<double> ask(const Command& query) {
    const GLenum a = query.enumerant(0), b = query.arguments.size() > 1 ? query.enumerant(1) : 0;
    const bool has_two = query.sig().parameters.size() > 2;
    const auto count = query.id == CommandId::glIsEnabled
                           ? 1
                           : static_cast<std::size_t>(array_length(query.id, has_two ? b : a).value_or(1));
    switch (query.id) {
        case CommandId::glGetLightfv: return asked<GLfloat>(count, [&](auto* v) { glGetLightfv(a, b, v); });
        case CommandId::glGetLightiv: return asked<GLint>(count, [&](auto* v) { glGetLightiv(a, b, v); });
        case CommandId::glGetMaterialfv: return asked<GLfloat>(count, [&](auto* v) { glGetMaterialfv(a, b, v); });
        case CommandId::glGetMaterialiv: return asked<GLint>(count, [&](auto* v) { glGetMaterialiv(a, b, v); });
        case CommandId::glGetTexEnvfv: return asked<GLfloat>(count, [&](auto* v) { glGetTexEnvfv(a, b, v); });
        case CommandId::glGetTexEnviv: return asked<GLint>(count, [&](auto* v) { glGetTexEnviv(a, b, v); });
        case CommandId::glGetTexGenfv: return asked<GLfloat>(count, [&](auto* v) { glGetTexGenfv(a, b, v); });
        case CommandId::glGetTexGendv: return asked<GLdouble>(count, [&](auto* v) { glGetTexGendv(a, b, v); });
        case CommandId::glGetTexGeniv: return asked<GLint>(count, [&](auto* v) { glGetTexGeniv(a, b, v); });
        case CommandId::glGetTexParameterfv:
            return asked<GLfloat>(count, [&](auto* v) { glGetTexParameterfv(a, b, v); });
        case CommandId::glGetTexParameteriv: return asked<GLint>(count, [&](auto* v) { glGetTexParameteriv(a, b, v); });
        case CommandId::glGetBooleanv: return asked<GLboolean>(count, [&](auto* v) { glGetBooleanv(a, v); });
        case CommandId::glGetIntegerv: return asked<GLint>(count, [&](auto* v) { glGetIntegerv(a, v); });
        case CommandId::glGetFloatv: return asked<GLfloat>(count, [&](auto* v) { glGetFloatv(a, v); });
        case CommandId::glGetDoublev: return asked<GLdouble>(count, [&](auto* v) { glGetDoublev(a, v); });
        case CommandId::glGetClipPlane: return asked<GLdouble>(count, [&](auto* v) { glGetClipPlane(a, v); });
        case CommandId::glIsEnabled: return asked<GLboolean>(count, [&](auto* v) { *v = glIsEnabled(a); });
        default: return {};
    }
}

}  // namespace

std::vector<std::vector<double>> answers(const Scene& scene) {
    std::vector<std::vector<double>> all;
    Driver driver(scene.frame.width, scene.frame.height);
    driver.make_empty_lists(scene.frame.lists_called_before_made);
    scene.recording->for_each([&](const Step& step) {
        if (step.kind != Step::Kind::kCommand) return true;
        if (is_answered(step.command.id))
            all.push_back(names_objects(step.command) ? std::vector<double>() : ask(step.command));
        else
            driver.execute(step.command);
        return true;
    });
    glFinish();
    return all;
}

}  // namespace twinlight::fixed
