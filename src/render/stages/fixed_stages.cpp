#include "render/stages/fixed_stages.h"

#include <array>
#include <utility>

#include "render/context/gl.h"

namespace twinlight {
namespace {

void set_enabled(GLenum capability, bool enabled) { (enabled ? glEnable : glDisable)(capability); }

// The bytes of glPolygonStipple: rows from the bottom, each from the highest bit of its first byte.
void set_stipples_and_smoothing(const RasterState& raster) {
    set_enabled(GL_LINE_STIPPLE, raster.line_stipple.has_value());
    if (raster.line_stipple) glLineStipple(raster.line_stipple->factor, raster.line_stipple->pattern);
    set_enabled(GL_POLYGON_STIPPLE, raster.polygon_stipple != nullptr);
    set_enabled(GL_LINE_SMOOTH, raster.line_smooth);
    set_enabled(GL_POINT_SMOOTH, raster.point_smooth);
    if (!raster.polygon_stipple) return;
    std::array<GLubyte, 128> bytes{};
    for (std::size_t row = 0; row < 32; ++row)
        for (std::size_t column = 0; column < 32; ++column)
            if (((*raster.polygon_stipple)[row] >> column & 1U) != 0)
                bytes[4 * row + column / 8] |= static_cast<GLubyte>(1U << (7 - column % 8));
    glPolygonStipple(bytes.data());
}

// GL_VERTEX_PROGRAM_POINT_SIZE counts only for shaders, which set the size of attenuated points. Beside a vertex shader, some drivers
// do not limit the size of the others (NVIDIA 580), so it is limited here.
void set_points(const RasterState& raster) {
    const PointParameters& points = raster.point_parameters;
    const double limited = points.derived_size(raster.point_size, 0);
    glPointSize(static_cast<float>(points.attenuates() || limited <= 0 ? raster.point_size : limited));
    glPointParameterf(GL_POINT_SIZE_MIN, static_cast<float>(points.size_min));
    glPointParameterf(GL_POINT_SIZE_MAX, static_cast<float>(points.size_max));
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, static_cast<float>(points.fade_threshold_size));
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, &glm::vec3(points.distance_attenuation)[0]);
    glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, static_cast<GLint>(points.sprite_coord_origin));
    set_enabled(GL_POINT_SPRITE, raster.point_sprite);
    set_enabled(GL_VERTEX_PROGRAM_POINT_SIZE, points.attenuates());
}

void set_faces(const RasterState& raster) {
    glFrontFace(raster.front_face);
    set_enabled(GL_CULL_FACE, raster.cull_enabled);
    glCullFace(raster.cull_face);
    glPolygonMode(GL_FRONT, raster.polygon_mode_front);
    glPolygonMode(GL_BACK, raster.polygon_mode_back);
}

void set_polygon_offset(const PolygonOffset& offset) {
    set_enabled(GL_POLYGON_OFFSET_POINT, offset.point);
    set_enabled(GL_POLYGON_OFFSET_LINE, offset.line);
    set_enabled(GL_POLYGON_OFFSET_FILL, offset.fill);
    glPolygonOffset(static_cast<float>(offset.factor), static_cast<float>(offset.units));
}

void set_logic_op(const std::optional<Enum>& logic_op) {
    set_enabled(GL_COLOR_LOGIC_OP, logic_op.has_value());
    if (logic_op) glLogicOp(*logic_op);
}

void set_scissor(const Scissor& scissor) {
    set_enabled(GL_SCISSOR_TEST, scissor.enabled);
    glScissor(scissor.box.x, scissor.box.y, scissor.box.width, scissor.box.height);
}

void set_color_mask(const std::array<bool, 4>& mask) { glColorMask(mask[0], mask[1], mask[2], mask[3]); }

void set_stencil(const std::optional<StencilTest>& stencil) {
    set_enabled(GL_STENCIL_TEST, stencil.has_value());
    if (!stencil) return;
    for (const auto& [name, face] : {std::pair(GL_FRONT, &stencil->front), {GL_BACK, &stencil->back}}) {
        const auto face_name = static_cast<GLenum>(name);
        glStencilFuncSeparate(face_name, face->func, face->ref, face->mask);
        glStencilOpSeparate(face_name, face->fail, face->depth_fail, face->depth_pass);
        glStencilMaskSeparate(face_name, face->write_mask);
    }
}

}  // namespace

FixedStages::FixedStages() {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    for (GLenum capability : {GL_POLYGON_SMOOTH, GL_VERTEX_PROGRAM_TWO_SIDE, GL_DEPTH_CLAMP,
                              GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE})
        glDisable(capability);
    glActiveTexture(GL_TEXTURE0);
    glEdgeFlag(GL_TRUE);
}

FixedStages::~FixedStages() {
    glUseProgram(0);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    glPopClientAttrib();
    glPopAttrib();
}

void FixedStages::set(const RasterState& raster, const RasterState* before) {
    const auto differ = [&](auto... members) {
        return before == nullptr || ((raster.*members != before->*members) || ...);
    };
    using State = RasterState;
    const Rectangle& v = raster.viewport;
    if (differ(&State::viewport)) glViewport(v.x, v.y, v.width, v.height);
    if (differ(&State::depth_near, &State::depth_far)) glDepthRange(raster.depth_near, raster.depth_far);
    if (differ(&State::front_face, &State::cull_enabled, &State::cull_face, &State::polygon_mode_front,
               &State::polygon_mode_back))
        set_faces(raster);
    if (differ(&State::polygon_offset)) set_polygon_offset(raster.polygon_offset);
    if (differ(&State::line_width)) glLineWidth(static_cast<float>(raster.line_width));
    if (differ(&State::point_size, &State::point_parameters, &State::point_sprite)) set_points(raster);
    // The program has one clip distance for each enabled plane, without gaps.
    const int count = raster.clip_plane_count();
    if (before == nullptr || count != before->clip_plane_count())
        for (int i = 0; i < kMaxClipPlanes; ++i) set_enabled(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i), i < count);
    if (differ(&State::depth_test)) set_enabled(GL_DEPTH_TEST, raster.depth_test);
    if (differ(&State::depth_func)) glDepthFunc(raster.depth_func);
    if (differ(&State::depth_mask)) glDepthMask(raster.depth_mask);
    if (differ(&State::line_stipple, &State::polygon_stipple, &State::line_smooth, &State::point_smooth))
        set_stipples_and_smoothing(raster);
}

void FixedStages::set(const FragmentState& fragment, const FragmentState* before) {
    const auto differ = [&](auto... members) {
        return before == nullptr || ((fragment.*members != before->*members) || ...);
    };
    using State = FragmentState;
    if (differ(&State::scissor)) set_scissor(fragment.scissor);
    if (differ(&State::alpha_test, &State::alpha_func, &State::alpha_ref)) {
        set_enabled(GL_ALPHA_TEST, fragment.alpha_test);
        glAlphaFunc(fragment.alpha_func, static_cast<float>(fragment.alpha_ref));
    }
    if (differ(&State::stencil)) set_stencil(fragment.stencil);
    if (differ(&State::logic_op)) set_logic_op(fragment.logic_op);
    if (differ(&State::blend)) set_enabled(GL_BLEND, fragment.blend);
    if (differ(&State::blend_src, &State::blend_dst, &State::blend_src_alpha, &State::blend_dst_alpha))
        glBlendFuncSeparate(fragment.blend_src, fragment.blend_dst, fragment.blend_src_alpha, fragment.blend_dst_alpha);
    if (differ(&State::blend_equation, &State::blend_equation_alpha))
        glBlendEquationSeparate(fragment.blend_equation, fragment.blend_equation_alpha);
    const glm::vec4 color(fragment.blend_color);
    if (differ(&State::blend_color)) glBlendColor(color.r, color.g, color.b, color.a);
    if (differ(&State::color_mask)) set_color_mask(fragment.color_mask);
}

void FixedStages::set(const RasterState& raster, const FragmentState& fragment) {
    set(raster);
    set(fragment);
}

void FixedStages::clear_all() const {
    clear({.color = true, .depth = true, .clear_color = glm::dvec4(0), .clear_depth = 1, .stencil = true});
}

// 4.2.3: clearing obeys the scissor and the masks.
void FixedStages::clear(const Clear& clear) const {
    set_scissor(clear.scissor);
    set_color_mask(clear.color_mask);
    glDepthMask(GL_TRUE);  // if the depth mask was off, the Clear has `depth` = false
    const glm::vec4 color(clear.clear_color);
    glClearColor(color.r, color.g, color.b, color.a);
    glClearDepth(clear.clear_depth);
    if (clear.stencil) {
        glClearStencil(clear.clear_stencil);
        glStencilMaskSeparate(GL_FRONT, clear.stencil_mask);
    }
    const GLbitfield buffers = (clear.color ? GL_COLOR_BUFFER_BIT : 0u) | (clear.depth ? GL_DEPTH_BUFFER_BIT : 0u) |
                               (clear.stencil ? GL_STENCIL_BUFFER_BIT : 0u);
    if (buffers != 0) glClear(buffers);
}

}  // namespace twinlight
