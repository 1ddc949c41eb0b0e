#include "render/fixed/replay.h"

#include <algorithm>
#include <array>
#include <deque>
#include <glm/common.hpp>
#include <optional>
#include <span>
#include <variant>

#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/effect/scrubbed_state.h"
#include "render/fixed/draw_state.h"
#include "render/fixed/fixed.h"
#include "render/fixed/freed_views.h"
#include "render/fixed/sent_mesh.h"
#include "render/stages/accumulation_buffer.h"
#include "render/stages/fixed_stages.h"
#include "render/stages/textures.h"
#include "scene/frame/copied_texels.h"

namespace twinlight::fixed {
namespace {

void set_clip_planes(const RasterState& raster) {
    GLenum plane = GL_CLIP_PLANE0;  // without gaps, as FixedStages enables them
    for (const auto& equation : raster.clip_planes_eye)
        if (equation) glClipPlane(plane++, &(*equation)[0]);
}

// Draws the pixels of these vertices of a Draw, which have one colour and one depth, as one bitmap. Its raster position has the
// values of the first vertex.
void draw_bitmap(const Draw& draw, std::size_t first, std::size_t end) {
    const auto places = std::span(draw.pixels->places).subspan(first, end - first);
    glm::ivec2 low = places.front(), high = low;
    for (const glm::ivec2& place : places) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    const auto whole = [](int number) { return static_cast<std::size_t>(number); };
    const glm::ivec2 size = high - low + 1;
    const std::size_t row = (whole(size.x) + 7) / 8;
    std::vector<GLubyte> bits(row * whole(size.y));
    for (const glm::ivec2& place : places)
        bits[whole(place.y - low.y) * row + whole(place.x - low.x) / 8] |=
            static_cast<GLubyte>(0x80 >> (place.x - low.x) % 8);
    send_values(draw, first);
    glDepthRange(draw.pixels->depth(first), draw.pixels->depth(first));  // of every position
    glRasterPos4dv(&draw.vertices[first].position_object[0]);
    std::array<GLfloat, 4> now{};
    glGetFloatv(GL_CURRENT_RASTER_POSITION, now.data());
    // To the middle of the first pixel, where rounding is far from its borders.
    glBitmap(0, 0, 0, 0, static_cast<float>(low.x) + 0.5F - now[0], static_cast<float>(low.y) + 0.5F - now[1], nullptr);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const KeepsViews views(KeepsViews::Drawn::kBitmap);
    glBitmap(size.x, size.y, 0, 0, 0, 0, bits.data());
    glFlush();  // see Driver::end_bitmaps()
}

void draw_image(const WindowPixels& pixels) {
    const TextureImage& image = pixels.image->levels.front();
    const glm::ivec2 corner = pixels.places.front();
    glWindowPos3d(corner.x, corner.y, pixels.depths.front());
    glDrawPixels(image.width, image.height, GL_RGBA, GL_FLOAT, image.texels.data());
}

// Without an image, pixels with nothing but a colour are drawn as points, because they may have many colours.
void draw_points(const Draw& draw) {
    load_matrix(GL_PROJECTION, glm::dmat4(1));
    load_matrix(GL_MODELVIEW, glm::dmat4(1));
    glBegin(GL_POINTS);
    for (std::size_t i = 0; i < draw.vertices.size(); ++i) {
        glColor4dv(&draw.vertices[i].color[0]);
        const glm::dvec3 place((glm::dvec2(draw.pixels->places[i]) + 0.5) / (kMostWindowPixels / 2.0),
                               2 * draw.pixels->depth(i));
        glVertex3dv(&(place - 1.0)[0]);
    }
    glEnd();
}

void draw_pixels(const Draw& draw) {
    const auto is_like = [&](std::size_t one, std::size_t other) {
        return draw.vertices[one].color == draw.vertices[other].color &&
               draw.pixels->depth(one) == draw.pixels->depth(other);
    };
    for (std::size_t first = 0; first < draw.vertices.size();) {
        std::size_t end = first + 1;
        while (end < draw.vertices.size() && is_like(end, first)) ++end;
        draw_bitmap(draw, first, end);
        first = end;
    }
}

// A Draw with the state to set for it.
struct PreparedDraw {
    PreparedDraw(const Draw& from, const ReplayOptions& options) : draw(&from) {
        shade_model = from.lighting.shade_model;
        if (options.shading) shade_model = *options.shading == Shading::kFlat ? GL_FLAT : GL_SMOOTH;
        MeshContents contents;
        if (options.scrub == Scrub::kNothing) {
            lighting = from.lighting;
            lighting.lights.resize(kMaxLights);
            textured = from.texture.texture && !from.combines_textures();
            if (from.combines_textures()) units = combined_units(from);
            fogged = from.fog.enabled;
            contents = {.normal = lighting.enabled,
                        .color = !lighting.enabled || lighting.color_material.enabled,
                        .tex_coord = from.texture.texture != nullptr,
                        .further_tex_coords = !units.empty()};
            front = back = {.varies_emission = true,
                            .varies_ambient = true,
                            .varies_diffuse = true,
                            .varies_specular = true,
                            .varies_shininess = true};
        } else {
            const Plan plan =
                plan_effects(from, {{.shading = options.shading, .lecture_variants = false}, options.budget});
            const EffectSet& effects = plan.effects;
            lighting = scrubbed_state(plan, kMaxLights).lighting;
            textured = effects.has_texture();
            if (!effects.units.empty()) units = combined_units(from);
            fogged = effects.has_fog();
            contents = {.normal = effects.needs_normal(),
                        .color = effects.needs_color(),
                        .tex_coord = textured || !units.empty(),
                        .further_tex_coords = !units.empty()};
            front = effects.front;
            back = effects.back;
        }
        if (textured)
            contents.normal |= std::ranges::any_of(from.texture.generated, &GeneratedCoordinate::needs_normal);
        for (const auto& [number, unit] : units)
            contents.normal |= std::ranges::any_of(unit.generated, &GeneratedCoordinate::needs_normal);
        by_vertex = !from.materials.empty() && (front.varies() || back.varies());
        if (!by_vertex && !from.pixels) mesh.emplace(from, contents, options);
    }

    void draw_with(const FixedStages& stages, Textures& textures) const {
        load_matrix(GL_MODELVIEW, glm::dmat4(1));
        set_lighting(lighting, false);
        set_clip_planes(draw->raster);
        stages.set(draw->raster, draw->fragment);
        glShadeModel(shade_model);
        set_enabled(GL_FOG, fogged);
        set_enabled(GL_COLOR_SUM, draw->column(VertexAttribute::kSecondaryColor) != nullptr);
        if (fogged) set_fog(draw->fog);
        set_texture(textures);
        load_matrix(GL_PROJECTION, draw->clip_from_eye);
        load_matrix(GL_MODELVIEW, draw->eye_from_object);
        const bool has_only_colors = !lighting.enabled && !textured && units.empty() && !fogged;
        if (draw->pixels && has_only_colors && !draw->column(VertexAttribute::kSecondaryColor))
            draw->pixels->image ? draw_image(*draw->pixels) : draw_points(*draw);
        else if (draw->pixels)
            draw_pixels(*draw);
        else if (by_vertex)
            draw_with_materials(*draw, front, back);
        else
            mesh->draw();
        if (!units.empty()) disable_units();
    }

    void set_texture(Textures& textures) const {
        glDisable(GL_TEXTURE_1D);
        glDisable(GL_TEXTURE_2D);
        glDisable(GL_TEXTURE_3D);
        glDisable(GL_TEXTURE_CUBE_MAP);
        if (textured) {
            textures.bind(draw->texture);
            set_unit(draw->texture);
        }
        if (units.empty()) return;
        textures.bind_units(units);
        for (const auto& [number, unit] : units) {
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(number));
            set_unit(unit);
        }
        glActiveTexture(GL_TEXTURE0);
    }

    // The active unit's.
    static void set_unit(const TextureUnit& unit) {
        glEnable(unit.texture->target);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(unit.env_mode));
        glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &glm::vec4(unit.env_color)[0]);
        if (unit.env_mode == kGL_COMBINE) set_combine(unit.combine);
        glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, unit.coord_replace);
        load_matrix(GL_TEXTURE, unit.texture_matrix);
        for (const GLenum capability : {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q}) {
            glDisable(capability);
        }
        for (const GeneratedCoordinate& one : unit.generated) {
            const GLenum number = static_cast<GLenum>(one.coordinate);
            glEnable(GL_TEXTURE_GEN_S + number);
            glTexGeni(GL_S + number, GL_TEXTURE_GEN_MODE, static_cast<GLint>(one.mode));
            const bool is_linear = one.mode == GL_OBJECT_LINEAR || one.mode == GL_EYE_LINEAR;
            if (is_linear)
                glTexGendv(GL_S + number, one.mode == GL_EYE_LINEAR ? GL_EYE_PLANE : GL_OBJECT_PLANE, &one.plane[0]);
        }
    }
    void disable_units() const {
        for (const auto& [number, unit] : units) {
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(number));
            glDisable(unit.texture->target);
        }
        Textures::release_units(units);
    }

    const Draw* draw;
    LightingState lighting;
    Enum shade_model;
    bool textured = false, fogged = false;  // textured: with one texture and without GL_COMBINE
    TextureUnits units;                     // if the Draw combines textures
    bool by_vertex = false;                 // glMaterial between glBegin and glEnd
    FaceEffects front, back;
    std::optional<SentMesh> mesh;
};

}  // namespace

struct Replay::Impl {
    Impl(const Frame& frame, const ReplayOptions& options)
        : width(frame.width),
          height(frame.height),
          whole(frame, [&](const Frame& picture, CopiedBuffer buffer, const Rectangle& area) {
              return drawn_to_copy(picture, buffer, area, [&] { Replay(picture, options).draw(); });
          }) {}

    int width, height;
    DrawableFrame whole;
    std::deque<Draw> stencil_draws;  // of one stencil value each
    std::deque<std::variant<Clear, PreparedDraw, Accumulate>> items;
    Textures textures{Clamping::kDriver};
};

Replay::Replay(const Frame& frame, const ReplayOptions& options) {
    check_shading(options.shading);
    impl_ = std::make_unique<Impl>(frame, options);
    for (const auto& item : (*impl_->whole).items) {
        if (const Clear* clear = std::get_if<Clear>(&item)) {
            impl_->items.emplace_back(*clear);
        } else if (const Accumulate* accumulate = std::get_if<Accumulate>(&item)) {
            impl_->items.emplace_back(*accumulate);
        } else if (const Draw* draw = std::get_if<Draw>(&item); draw && draw->pixels && draw->pixels->has_stencils) {
            for (Draw& one : by_stencil_value(*draw))
                impl_->items.emplace_back(std::in_place_type<PreparedDraw>,
                                          impl_->stencil_draws.emplace_back(std::move(one)), options);
        } else if (draw) {
            impl_->items.emplace_back(std::in_place_type<PreparedDraw>, *draw, options);
        }
    }
}

Replay::~Replay() = default;

void Replay::draw() {
    const InitialState initial(impl_->width, impl_->height);
    const FixedStages stages;
    stages.clear_all();
    AccumulationBuffer accumulation(impl_->width, impl_->height);
    for (const auto& item : impl_->items) {
        if (const Clear* clear = std::get_if<Clear>(&item)) {
            stages.clear(*clear);
            accumulation.clear(*clear);
        } else if (const Accumulate* accumulate = std::get_if<Accumulate>(&item)) {
            accumulation.apply(*accumulate);
        } else {
            std::get<PreparedDraw>(item).draw_with(stages, impl_->textures);
        }
    }
}

Image render_scrubbed(const Scene& scene, const std::optional<Shading>& shading, double budget) {
    const Frame& frame = scene.frame;
    const bool is_whole = std::ranges::none_of(frame.unsupported, [](const Unsupported& item) {
        return item.missing_from == MissingFrom::kFrame || item.missing_from == MissingFrom::kEverything;
    });
    if (!is_whole) return render(scene, {shading});
    Replay(frame, {.shading = shading, .scrub = Scrub::kState, .budget = budget, .patches = false}).draw();
    glFinish();
    return read_pixels(frame.width, frame.height);
}

}  // namespace twinlight::fixed
