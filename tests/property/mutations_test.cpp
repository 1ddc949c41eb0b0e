// Which errors of a renderer the comparison finds: one thing at a time is changed in what the reference draws, as if another renderer
// had drawn it, and the picture is judged like that renderer's. `make test` tries a sample, and ALL_CASES all (docs/edges.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../unit/effort.h"
#include "../unit/run_program.h"
#include "../unit/sanitized.h"
#include "judge/compare/judged.h"
#include "judge/compare/tolerance.h"
#include "judge/compare/vertex_colors.h"
#include "judge/lesson/lesson.h"
#include "render/reference/reference.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::mutations_test {
namespace {

constexpr int kSide = 256;
using compare::kGlsOwnModel;

// ---- The errors ----

struct Mutation {
    const char* words;
    std::function<void(Draw&)> apply;  // leaves the Draw as it is where it does not apply
};

template <class Change>
Mutation of_lights(const char* words, const Change& change) {
    return {words, [change](Draw& draw) {
                for (LightSource& light : draw.lighting.lights)
                    if (light.enabled) change(light);
            }};
}
template <class Change>
Mutation of_materials(const char* words, const Change& change) {
    return {words, [change](Draw& draw) {
                for (Material* material : {&draw.lighting.front, &draw.lighting.back}) change(*material);
                for (Materials& materials : draw.materials)
                    for (Material* material : {&materials.front, &materials.back}) change(*material);
            }};
}
template <class Change>
Mutation of_vertices(const char* words, const Change& change) {
    return {words, [change](Draw& draw) {
                if (draw.pixels) return;
                for (Vertex& vertex : draw.vertices.edit()) change(vertex);
            }};
}
template <class Change>
Mutation of_textures(const char* words, const Change& change) {
    return {words, [change](Draw& draw) {
                if (!draw.texture.texture) return;
                Texture texture = *draw.texture.texture;
                change(draw.texture, texture);
                draw.texture.texture = std::make_shared<const Texture>(std::move(texture));
            }};
}
glm::dvec4 scaled(const glm::dvec4& color, double factor) { return {factor * glm::dvec3(color), color.a}; }

// Each vertex has the value of the one before it.
template <class Value>
Mutation late(const char* words, Value Vertex::*value) {
    return {words, [value](Draw& draw) {
                if (draw.pixels || draw.vertices.empty()) return;
                std::vector<Vertex>& vertices = draw.vertices.edit();
                for (std::size_t i = vertices.size() - 1; i > 0; --i) vertices[i].*value = vertices[i - 1].*value;
            }};
}

LightSource* light_of(Draw& draw, bool last) {
    LightSource* found = nullptr;
    for (LightSource& light : draw.lighting.lights)
        if (light.enabled && (last || !found)) found = &light;
    return found;
}

const std::vector<Mutation>& mutations() {
    static const std::vector<Mutation> all = {
        // The terms of the equation (2.14.1).
        of_lights("ambient term times 0.98", [](LightSource& l) { l.ambient = scaled(l.ambient, 0.98); }),
        of_lights("diffuse term times 0.98", [](LightSource& l) { l.diffuse = scaled(l.diffuse, 0.98); }),
        of_lights("specular term times 0.98", [](LightSource& l) { l.specular = scaled(l.specular, 0.98); }),
        of_lights("no ambient term", [](LightSource& l) { l.ambient = scaled(l.ambient, 0); }),
        of_lights("no diffuse term", [](LightSource& l) { l.diffuse = scaled(l.diffuse, 0); }),
        of_lights("no specular term", [](LightSource& l) { l.specular = scaled(l.specular, 0); }),
        of_materials("no emission", [](Material& m) { m.emission = scaled(m.emission, 0); }),
        {"no ambient light of the model",
         [](Draw& draw) { draw.lighting.light_model.ambient = scaled(draw.lighting.light_model.ambient, 0); }},
        {"ambient light of the model times 0.9",
         [](Draw& draw) { draw.lighting.light_model.ambient = scaled(draw.lighting.light_model.ambient, 0.9); }},
        of_materials("alpha of the diffuse colour times 0.9", [](Material& m) { m.diffuse.a *= 0.9; }),
        of_materials("ambient from the diffuse colour", [](Material& m) { m.ambient = m.diffuse; }),
        // Attenuation.
        of_lights("no k_1", [](LightSource& l) { l.linear_attenuation = 0; }),
        of_lights("no k_2", [](LightSource& l) { l.quadratic_attenuation = 0; }),
        of_lights("k_0 is 1", [](LightSource& l) { l.constant_attenuation = 1; }),
        of_lights("no attenuation",
                  [](LightSource& l) {
                      l.constant_attenuation = 1;
                      l.linear_attenuation = l.quadratic_attenuation = 0;
                  }),
        of_lights("the distance squared in k_1",
                  [](LightSource& l) {
                      l.quadratic_attenuation += l.linear_attenuation;
                      l.linear_attenuation = 0;
                  }),
        // Highlights.
        of_materials("exponent + 1", [](Material& m) { m.shininess += 1; }),
        of_materials("exponent times 1.1", [](Material& m) { m.shininess *= 1.1; }),
        of_materials("exponent at most 64", [](Material& m) { m.shininess = std::min(m.shininess, 64.0); }),
        {"another viewer",
         [](Draw& draw) { draw.lighting.light_model.local_viewer = !draw.lighting.light_model.local_viewer; }},
        {"separate specular colour, or not",
         [](Draw& draw) {
             Enum& control = draw.lighting.light_model.color_control;
             control = control == kGL_SINGLE_COLOR ? kGL_SEPARATE_SPECULAR_COLOR : kGL_SINGLE_COLOR;
         }},
        // Faces.
        {"two sides, or one",
         [](Draw& draw) { draw.lighting.light_model.two_side = !draw.lighting.light_model.two_side; }},
        {"faces swapped", [](Draw& draw) { std::swap(draw.lighting.front, draw.lighting.back); }},
        {"the other face is culled",
         [](Draw& draw) { draw.raster.cull_face = draw.raster.cull_face == kGL_BACK ? kGL_FRONT : kGL_BACK; }},
        // Lights.
        {"the first light is missing",
         [](Draw& draw) {
             if (LightSource* light = light_of(draw, false)) light->enabled = false;
         }},
        {"the last light is missing",
         [](Draw& draw) {
             if (LightSource* light = light_of(draw, true)) light->enabled = false;
         }},
        of_lights("lights 2% nearer", [](LightSource& l) { l.position_eye = scaled(l.position_eye, 0.98); }),
        of_lights("lights 5% to the right",
                  [](LightSource& l) { l.position_eye.x += 0.05 * glm::length(glm::dvec3(l.position_eye)); }),
        of_lights("every light is directional", [](LightSource& l) { l.position_eye.w = 0; }),
        of_lights("no light is directional",
                  [](LightSource& l) {
                      if (l.position_eye.w == 0) l.position_eye.w = 1;
                  }),
        of_lights("no spots", [](LightSource& l) { l.spot_cutoff_deg = 180; }),
        of_lights("cutoff + 1 degree",
                  [](LightSource& l) {
                      if (l.spot_cutoff_deg < 89) l.spot_cutoff_deg += 1;
                  }),
        of_lights("spot exponent + 1", [](LightSource& l) { l.spot_exponent += 1; }),
        of_lights("spot direction of the initial state",
                  [](LightSource& l) {
                      l.spot_direction_eye = {0, 0, -1};
                  }),
        // Colour material and vertices.
        late("the current colour one vertex late", &Vertex::color),
        late("the normal one vertex late", &Vertex::normal_object),
        late("texture coordinates one vertex late", &Vertex::tex_coord),
        {"colour material is off", [](Draw& draw) { draw.lighting.color_material.enabled = false; }},
        {"colour material tracks the diffuse colour only",
         [](Draw& draw) { draw.lighting.color_material.mode = kGL_DIFFUSE; }},
        of_vertices("normals turned around", [](Vertex& v) { v.normal_object = -v.normal_object; }),
        {"GL_NORMALIZE is off", [](Draw& draw) { draw.lighting.normalize = false; }},
        {"GL_RESCALE_NORMAL instead of GL_NORMALIZE",
         [](Draw& draw) {
             if (draw.lighting.normalize) draw.lighting.rescale_normal = true;
             draw.lighting.normalize = false;
         }},
        of_vertices("normals 5% longer", [](Vertex& v) { v.normal_object *= 1.05; }),
        {"flat, or smooth",
         [](Draw& draw) { draw.lighting.shade_model = draw.lighting.shade_model == kGL_FLAT ? kGL_SMOOTH : kGL_FLAT; }},
        {"not lit", [](Draw& draw) { draw.lighting.enabled = false; }},
        // Fog (3.10).
        {"no fog", [](Draw& draw) { draw.fog.enabled = false; }},
        {"fog's density times 1.05, its end times 0.95",
         [](Draw& draw) {
             draw.fog.density *= 1.05;
             draw.fog.end *= 0.95;
         }},
        {"GL_EXP2 instead of GL_EXP, or back",
         [](Draw& draw) {
             if (draw.fog.mode != kGL_LINEAR) draw.fog.mode = draw.fog.mode == kGL_EXP ? kGL_EXP2 : kGL_EXP;
         }},
        {"fog's colour times 0.9", [](Draw& draw) { draw.fog.color = scaled(draw.fog.color, 0.9); }},
        // Textures (3.8).
        {"no texture", [](Draw& draw) { draw.texture.texture = nullptr; }},
        of_textures("a texture level too coarse", [](TextureUnit& unit, Texture&) { unit.lod_bias += 1; }),
        of_textures("nearest filters",
                    [](TextureUnit&, Texture& texture) { texture.min_filter = texture.mag_filter = kGL_NEAREST; }),
        of_textures("GL_REPLACE for GL_MODULATE, or back",
                    [](TextureUnit& unit, Texture&) {
                        if (unit.env_mode == kGL_MODULATE || unit.env_mode == kGL_REPLACE)
                            unit.env_mode = unit.env_mode == kGL_MODULATE ? kGL_REPLACE : kGL_MODULATE;
                    }),
        of_vertices("texture coordinates off by 0.02", [](Vertex& v) { v.tex_coord.s += 0.02; }),
        {"no texture matrix", [](Draw& draw) { draw.texture.texture_matrix = glm::dmat4(1); }},
        // Rasterisation and fragments (chapters 3 and 4).
        {"no blending", [](Draw& draw) { draw.fragment.blend = false; }},
        {"GL_ONE as blending's source factor",
         [](Draw& draw) {
             if (draw.fragment.blend) draw.fragment.blend_src = kGL_ONE;
         }},
        {"no alpha test", [](Draw& draw) { draw.fragment.alpha_test = false; }},
        {"no stencil test", [](Draw& draw) { draw.fragment.stencil.reset(); }},
        {"no logical operation", [](Draw& draw) { draw.fragment.logic_op.reset(); }},
        {"no depth test", [](Draw& draw) { draw.raster.depth_test = false; }},
        {"GL_LEQUAL for GL_LESS, or back",
         [](Draw& draw) {
             if (draw.raster.depth_func == kGL_LESS || draw.raster.depth_func == kGL_LEQUAL)
                 draw.raster.depth_func = draw.raster.depth_func == kGL_LESS ? kGL_LEQUAL : kGL_LESS;
         }},
        {"no polygon offset", [](Draw& draw) { draw.raster.polygon_offset = {}; }},
        {"two pixels too far to the right", [](Draw& draw) { draw.raster.viewport.x += 2; }},
        // Two pixels would be one at each side, where 3.4.1 lets lines be off.
        {"lines and points four pixels wider",
         [](Draw& draw) {
             draw.raster.line_width += 4;
             draw.raster.point_size += 4;
         }},
        {"no clip planes", [](Draw& draw) { draw.raster.clip_planes_eye = {}; }},
        {"no stipples",
         [](Draw& draw) {
             draw.raster.line_stipple.reset();
             draw.raster.polygon_stipple.reset();
         }},
    };
    return all;
}

// ---- The pictures ----

struct Input {
    std::string name;
    std::function<Frame()> frame;
};

Frame loaded(const std::string& scene, const std::string& step = "") {
    const auto recording = load_recording(scene, WindowSize{kSide, kSide}, step);
    FrameChoice choice;
    choice.width = choice.height = kSide;
    if (const auto list = std::dynamic_pointer_cast<const CommandList>(recording))
        return make_scene(list, {.width = kSide, .height = kSide}).frame;
    return make_recorded_frame(recording, choice).scene.frame;
}

std::string sphere_of(int slices) {
    return fmt::format(
        "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); glEnable(GL_DEPTH_TEST);\n"
        "glMatrixMode(GL_PROJECTION); gluPerspective(40, 1, 1, 10); glMatrixMode(GL_MODELVIEW);\n"
        "glTranslatef(0, 0, -4); glRotatef(30, 1, 1, 0);\n"
        "GLfloat at[] = {{2, 3, 2, 1}}, gold[] = {{0.8, 0.6, 0.2, 1}}, white[] = {{1, 1, 1, 1}};\n"
        "glLightfv(GL_LIGHT0, GL_POSITION, at); glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.1);\n"
        "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, gold); glMaterialfv(GL_FRONT, GL_SPECULAR, white);\n"
        "glMaterialf(GL_FRONT, GL_SHININESS, 20); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n"
        "glutSolidSphere(1, {0}, {0});\n",
        slices);
}

std::vector<Input> inputs(const TemporaryFolder& folder) {
    std::vector<Input> all;
    const auto add = [&](const std::string& scene, const std::string& step = "") {
        all.push_back({step.empty() ? scene : scene + ", step " + step, [=] { return loaded(scene, step); }});
    };
    const auto add_text = [&](const std::string& name, const std::string& text) {
        write_file_atomically(folder / name, text);
        add(folder / name);
    };
    for (const EmbeddedFile& file : kSceneFiles) {
        const std::string name(file.name.substr(0, file.name.rfind('.')));
        const std::size_t steps = read_built_in(file).steps.size();
        if (steps == 0) add(name);
        for (std::size_t step = 1; step <= steps; ++step) add(name, std::to_string(step));
    }
    for (const int slices : {8, 16, 32, 64, 100, 200, 300})
        add_text(fmt::format("sphere-{}.gl", slices), sphere_of(slices));
    for (const EmbeddedFile& file : kLessonFiles) {
        const std::string name(file.name.substr(0, file.name.rfind('.')));
        for (const bool changed : {false, true}) {
            const std::string scene = folder / (name + (changed ? "-changed.gl" : ".gl"));
            std::vector<std::string> lesson = {"lesson", name, "-o", scene};
            if (changed) lesson.emplace_back("--changed");
            EXPECT_EQ(run_program("twinlight", lesson).status, 0) << name;
            add(scene);
        }
    }
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator("tests/traces"))
        if (entry.is_directory()) files.push_back(entry.path() / "dump.txt");
    for (const auto& entry : std::filesystem::directory_iterator("tests/homework"))
        if (entry.path().extension() == ".c") files.push_back(entry.path());
    std::ranges::sort(files);
    for (const std::string& file : files) add(file);
    return all;
}

// ---- What is found ----

struct Count {
    int small = 0,
        small_found = 0;  // pictures in which 20 pixels or more are moved by over 2/255 beyond what is allowed there
    int large = 0, large_found = 0;  // by over 16/255
    std::vector<std::string> missed;
};
constexpr int kFewPixels = 20;

// How many pixels are off by more than this, beyond what is allowed: away from edges the allowed difference; at an edge the range in
// which the right colour lies (of a smooth line what coverage may make of it), but not what else the pixel may be.
int moved(const Image& picture, const Image& right, const AllowedDifference& allowed, double by) {
    int count = 0;
    for (std::size_t i = 0; i < right.pixels.size(); ++i) {
        if (!allowed.is_judged(i)) continue;
        const Rgba &color = picture.pixels[i], &of_right = right.pixels[i], more = allowed.channels(i);
        AllowedRange range{of_right, of_right};
        if (allowed.edge[i])
            for (const AllowedRange& one : allowed.ranges.at(i)) {
                bool has_right = true;
                for (std::size_t c = 0; c < 3; ++c)
                    has_right = has_right && one.low[c] <= of_right[c] && of_right[c] <= one.high[c];
                if (!has_right) continue;
                for (std::size_t c = 0; c < 3; ++c) {
                    range.low[c] = std::min(range.low[c], one.low[c]);
                    range.high[c] = std::max(range.high[c], one.high[c]);
                }
            }
        float most = 0;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max({most, range.low[c] - more[c] - color[c], color[c] - range.high[c] - more[c]});
        count += static_cast<double>(most) > by ? 1 : 0;
    }
    return count;
}

class Judge {
  public:
    explicit Judge(const Frame& frame) : right_(reference::render(frame, {kGlsOwnModel})) {
        if (reference::has_quadrilaterals(frame))
            other_cut_ = reference::render(frame, {kGlsOwnModel, reference::QuadCut::kSecondToFourth});
        allowed_ = reference::allowed_difference(frame, {kGlsOwnModel});
        compare::allow_reference(allowed_, right_, other_cut_ ? &*other_cut_ : nullptr);
        compare::allow_ties(allowed_, right_);
    }
    const Image& right() const { return right_; }
    const AllowedDifference& allowed() const { return allowed_; }
    bool finds(const Image& picture) const {
        const Image& nearer = other_cut_ ? nearer_of(picture, right_, *other_cut_, allowed_.channels()) : right_;
        return !compare::is_within(difference(picture, nearer, allowed_), {});
    }

  private:
    Image right_;
    std::optional<Image> other_cut_;
    AllowedDifference allowed_;
};

TEST(Mutations, AreFoundInEveryPicture) {
    if (kSanitized) GTEST_SKIP() << "pictures are the same without sanitizers";
    const TemporaryFolder folder;
    const std::vector<Input> pictures = inputs(folder);
    constexpr std::size_t kStride = 24;  // of the sample: each mutation meets other pictures
    std::vector<Count> counts(mutations().size());
    int false_alarms = 0, tried = 0;
    for (std::size_t p = 0; p < pictures.size(); ++p) {
        std::optional<Judge> judge;
        std::optional<Frame> frame;
        for (std::size_t m = 0; m < mutations().size(); ++m) {
            if (!tries_all() && (p % kStride != 0 || (p / kStride + m) % 2 != 0)) continue;
            if (!frame) frame = pictures[p].frame();
            if (!judge) {
                judge.emplace(*frame);
                false_alarms += judge->finds(judge->right()) ? 1 : 0;
            }
            Frame changed = *frame;
            for (Draw* draw : changed.editable_draws()) mutations()[m].apply(*draw);
            const Image picture = reference::render(changed, {kGlsOwnModel});
            ++tried;
            const bool is_small = moved(picture, judge->right(), judge->allowed(), 2 / 255.0) >= kFewPixels;
            if (!is_small) continue;
            const bool is_large = moved(picture, judge->right(), judge->allowed(), 16 / 255.0) >= kFewPixels,
                       is_found = judge->finds(picture);
            Count& count = counts[m];
            ++count.small;
            count.small_found += is_found ? 1 : 0;
            count.large += is_large ? 1 : 0;
            count.large_found += is_large && is_found ? 1 : 0;
            if (!is_found) {
                const compare::Judged judged = compare::judged(judge->allowed());
                count.missed.push_back(fmt::format(
                    "{}{}: ranges of up to {:.0f}/255 in 95% of the edge pixels, {:.1f}% open",
                    std::filesystem::path(pictures[p].name).filename() == "dump.txt"
                        ? std::filesystem::path(pictures[p].name).parent_path().filename().string()
                        : std::filesystem::path(pictures[p].name).filename().string(),
                    is_large ? " (by over 16/255)" : "", 255 * judged.width.most, 100 * judged.open_share()));
            }
        }
    }
    Count sum;
    for (std::size_t m = 0; m < counts.size(); ++m) {
        const Count& count = counts[m];
        if (tries_all())
            fmt::print("| {} | {} | {} | {} | {} |\n", mutations()[m].words, count.small, count.small_found,
                       count.large, count.large_found);
        for (const std::string& missed : count.missed) fmt::print("missed: {}: {}\n", mutations()[m].words, missed);
        sum.small += count.small;
        sum.small_found += count.small_found;
        sum.large += count.large;
        sum.large_found += count.large_found;
    }
    fmt::print("{} mutated pictures of {}; {} of {} found that move {} pixels by over 2/255, {} of {} by over 16/255\n",
               tried, pictures.size(), sum.small_found, sum.small, kFewPixels, sum.large_found, sum.large);
    EXPECT_EQ(false_alarms, 0);
    EXPECT_GT(sum.large, tries_all() ? 2000 : 40);
    EXPECT_GE(sum.small_found, 0.99 * sum.small);
    EXPECT_GE(sum.large_found, 0.995 * sum.large) << "what is missed lies in each other (docs/edges.md)";
}

}  // namespace
}  // namespace twinlight::mutations_test
