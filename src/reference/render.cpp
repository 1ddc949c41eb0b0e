// The picture: colours of what is visible, interpolated (gouraud), of the provoking vertex (flat), or lit for
// every pixel (phong, which GL itself does not have).
#include <optional>

#include "reference/reference.h"
#include "reference/visibility.h"

namespace twinlight::reference {

namespace {

Shading shading_of(const Draw& draw, const RenderOptions& options) {
    if (options.shading) return *options.shading;
    return draw.lighting.shade_model == kGL_FLAT ? Shading::kFlat : Shading::kGouraud;
}

// 3.9: the secondary colour is added to the primary one; the alpha is the primary one's. Both are clamped before.
glm::dvec4 color_sum(const glm::dvec4& primary, const glm::dvec4& secondary) {
    return clamped(glm::dvec4(glm::dvec3(primary) + glm::dvec3(secondary), primary.a));
}

// Colours one Draw's pieces.
class Shader {
  public:
    Shader(const StagedDraw& staged, const RenderOptions& options)
        : vertices_(staged.vertices),
          shading_(shading_of(*staged.draw, options)),
          lighting_(staged.draw->lighting, options.lecture_variants) {
        if (lights_pixels()) return;
        lit_ = light_vertices(*staged.draw, options, true);
    }

    glm::dvec4 color(const Piece& piece, const glm::dvec2& position_window) const {
        // 2.14.7: one colour for the whole primitive.
        if (shading_ == Shading::kFlat) {
            const LitVertex& v = lit_[piece.primitive.provoking];
            return color_sum(primary(v, piece.face), secondary(v, piece.face));
        }
        const glm::dvec3 weights = weights_at(piece, position_window);
        return lights_pixels() ? phong(piece, weights) : gouraud(piece, weights);
    }

  private:
    bool lights_pixels() const { return shading_ == Shading::kPhong && lighting_.enabled(); }

    static const glm::dvec4& primary(const LitVertex& v, Face face) {
        return face == Face::kFront ? v.front_primary : v.back_primary;
    }
    static const glm::dvec4& secondary(const LitVertex& v, Face face) {
        return face == Face::kFront ? v.front_secondary : v.back_secondary;
    }

    glm::dvec4 gouraud(const Piece& piece, const glm::dvec3& weights) const {
        glm::dvec4 primary_sum(0), secondary_sum(0);
        for (int i = 0; i < 3; ++i) {
            const LitVertex& v = lit_[piece.primitive.vertices[i]];
            primary_sum += weights[i] * primary(v, piece.face);
            secondary_sum += weights[i] * secondary(v, piece.face);
        }
        return color_sum(primary_sum, secondary_sum);
    }

    // RULING (not GL's): the interpolated normal is made a unit vector; the colour that the material tracks
    // is interpolated too; the clamp of 2.14.6 is the pixel's.
    glm::dvec4 phong(const Piece& piece, const glm::dvec3& weights) const {
        StageVertex pixel;
        for (int i = 0; i < 3; ++i) {
            const StageVertex& v = vertices_[piece.primitive.vertices[i]];
            pixel.position_eye += weights[i] * v.position_eye;
            pixel.normal_eye += weights[i] * v.normal_eye;
            pixel.color += weights[i] * v.color;
        }
        const Vec normal_dir = lighting::unit(vec3_cast<Vec>(pixel.normal_eye));
        const Face face = lighting_.two_side() ? piece.face : Face::kFront;
        const Colors colors =
            lighting_.colors(pixel.position_eye, vec3_cast<glm::dvec3>(normal_dir), pixel.color, face);
        return color_sum(clamped(colors.primary), clamped(colors.secondary));
    }

    const std::vector<StageVertex>& vertices_;
    const Shading shading_;
    const DrawLighting lighting_;
    std::vector<LitVertex> lit_;
};

Rgba rgba(const glm::dvec4& color) {
    return {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b),
            static_cast<float>(color.a)};
}

}  // namespace

Image render(const Frame& frame, const RenderOptions& options) {
    const Stages stages = run_stages(frame, options.quad_cut);
    std::vector<Shader> shaders;
    shaders.reserve(stages.draws.size());
    for (const StagedDraw& staged : stages.draws) shaders.emplace_back(staged, options);

    Image image(frame.width, frame.height);
    for_each_band(frame.height, [&](int y0, int y1) {
        const VisibleRows rows = visible_rows(stages, frame.width, y0, y1);
        for (int y = y0; y < y1; ++y)
            for (int x = 0; x < frame.width; ++x) {
                const StepId id = rows.step[rows.index(x, y)];
                const glm::dvec4 color =
                    id < 0 ? clamped(stages.clear(id).clear_color)
                           : shaders[stages.piece(id).draw].color(stages.piece(id), pixel_centre(x, y));
                image.at(x, frame.height - 1 - y) = rgba(color);
            }
    });
    return image;
}

}  // namespace twinlight::reference
