#include "fuzz/floats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "command/text.h"
#include "context/gl.h"
#include "fixed/fixed.h"
#include "reference/reference.h"
#include "state/state.h"

namespace twinlight::fuzz {

namespace {

constexpr RenderOptions kGlsOwnModel = {.shading = {}, .lecture_variants = false, .budget = 0};
constexpr int kWindow = 64;  // of the fixed function's feedback
constexpr int kTile = 4;     // of a scene in the shaders' picture: a vertex stands in each corner
constexpr int kTiles = 32;   // in a row
static_assert(kTiles * kTiles == Floats::kMostScenes);

// What a channel may be off by, relative to the sum of the magnitudes of a colour's terms, in units of a float's last place.
// 2.1.1 allows each operation 1e-5; what drivers and shaders really lose is less.
constexpr double kUlp = 0x1p-23;
constexpr double kArithmeticUlps = 40;  // as many operations deep
// Of n.h, which its power multiplies by the exponent: a unit normal, and one that is the product of an inverse matrix that
// the driver has in floats.
constexpr double kUnitCosineUlps = 1, kCosineUlps = 3;
// Of the logarithm that a power is made of: it is multiplied by the exponent, and matters where n.h is greater than 1, for
// then the power is the greatest term by far.
constexpr double kLogarithmUlps = 5;
// Of each of the two unit vectors whose sum is made unit to h_i: where they nearly cancel, the sum is as far off, but short.
constexpr double kHalfVectorUlps = 1;

// The shortest sum of the directions to a light and to the viewer: 2 at most.
double shortest_half_vector(const Draw& draw, const Vertex& vertex) {
    const glm::dvec4 at = draw.eye_from_object * vertex.position_object;
    const glm::dvec3 position_eye = glm::dvec3(at) / at.w;
    const glm::dvec3 to_viewer =
        draw.lighting.light_model.local_viewer ? glm::normalize(-position_eye) : glm::dvec3(0, 0, 1);
    double shortest = 2;
    for (const LightSource& light : draw.lighting.lights) {
        if (!light.enabled) continue;
        const glm::dvec3 direction(light.position_eye);
        const double w = light.position_eye.w;
        const glm::dvec3 to_light = glm::normalize(w == 0 ? direction : direction / w - position_eye);
        shortest = std::min(shortest, glm::length(to_light + to_viewer));
    }
    return shortest;
}

double bar(const Draw& draw, const Vertex& vertex) {
    const LightingState& lighting = draw.lighting;
    const Materials materials =
        draw.materials.empty() ? Materials{lighting.front, lighting.back} : draw.materials[vertex.material];
    const double exponent = std::max(materials.front.shininess, materials.back.shininess);
    const double of_half_vector = 2 * kHalfVectorUlps / shortest_half_vector(draw, vertex);
    if (lighting.normalize) return kUlp * (kArithmeticUlps + (kUnitCosineUlps + of_half_vector) * exponent);
    const glm::dvec3 normal_eye = glm::transpose(glm::inverse(glm::dmat3(draw.eye_from_object))) * vertex.normal_object;
    const double length = lighting.rescale_normal ? 1 : std::max(1.0, glm::length(normal_eye));
    return kUlp * (kArithmeticUlps + (kCosineUlps + of_half_vector + kLogarithmUlps * std::log(length)) * exponent);
}

using Color = std::optional<glm::dvec4>;  // nothing where a renderer shows no such vertex

struct Scene {
    std::shared_ptr<const CommandList> commands;
    Frame frame;
    std::vector<reference::LitVertex> lit;
    std::vector<Color> fixed{}, programmable{};

    const Draw& draw() const { return std::get<Draw>(frame.items.back()); }
};

glm::dvec2 ndc(const reference::LitVertex& vertex) { return glm::dvec2(vertex.position_clip) / vertex.position_clip.w; }

// Each vertex in a corner of the view of its own, where feedback and the shaders' picture have a place for it.
bool stands_in_corners(const std::vector<reference::LitVertex>& lit) {
    std::array<bool, 4> taken{};
    for (const reference::LitVertex& vertex : lit) {
        const glm::dvec2 place = ndc(vertex);
        const glm::dvec2 size = glm::abs(place);
        const double depth = std::abs(vertex.position_clip.z / vertex.position_clip.w);
        const bool is_in_corner =
            vertex.position_clip.w > 0 && std::min(size.x, size.y) > 0.5 && std::max({size.x, size.y, depth}) < 1;
        bool& corner = taken.at((place.x > 0 ? 1u : 0u) + (place.y > 0 ? 2u : 0u));
        if (!is_in_corner || corner) return false;
        corner = true;
    }
    return true;
}

// The sign of a triangle's area in window space decides its face (2.14.1); points and lines show the front.
bool shows_back(const Scene& scene) {
    const Draw& draw = scene.draw();
    if (!draw.lighting.light_model.two_side || !draws_polygons(draw.mode)) return false;
    const glm::dvec2 a = ndc(scene.lit[0]), b = ndc(scene.lit[1]), c = ndc(scene.lit[2]);
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    return draw.raster.front_face == kGL_CCW ? area <= 0 : area >= 0;
}

// Nothing, and the reason, for a scene that GL refuses or that is not of this form.
std::optional<Scene> make_scene(const std::shared_ptr<const CommandList>& commands, std::string& error) {
    try {
        Scene scene{commands, make_frame(commands, {.width = kWindow, .height = kWindow}), {}};
        const Draw* draw = scene.frame.items.empty() ? nullptr : std::get_if<Draw>(&scene.frame.items.back());
        const std::size_t least = draw && draws_polygons(draw->mode) ? 3 : 1;
        if (!draw || !draw->lighting.enabled || draw->vertices.size() < least || draw->vertices.size() > 3)
            error = "the last thing drawn is not a lit primitive of three vertices";
        else if (!scene.frame.unsupported.empty())
            error = scene.frame.unsupported.front().name + " is not supported";
        if (!error.empty()) return std::nullopt;
        scene.lit = reference::light_vertices(*draw, kGlsOwnModel, false);
        if (!stands_in_corners(scene.lit)) error = "two vertices stand in one corner of the view, or one in none";
        if (!error.empty()) return std::nullopt;
        scene.fixed.resize(scene.lit.size());
        scene.programmable.resize(scene.lit.size());
        return scene;
    } catch (const SceneError& refused) {
        error = refused.what();
        return std::nullopt;
    }
}

// ---- The fixed function ----

// The colours that feedback returns (5.3), by where their vertices stand in the window.
void ask_fixed(Scene& scene) {
    std::array<GLfloat, 512> buffer{};
    glFeedbackBuffer(static_cast<GLsizei>(buffer.size()), GL_3D_COLOR, buffer.data());
    fixed::Driver driver(kWindow, kWindow);
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    glRenderMode(GL_FEEDBACK);
    for (const Command& command : scene.commands->commands) driver.execute(command);
    const GLint written = glRenderMode(GL_RENDER);
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_TRUE);
    constexpr std::size_t kPerVertex = 7;  // GL_3D_COLOR: x, y, z, r, g, b, a
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::max(written, 0));) {
        const auto token = static_cast<GLenum>(buffer[i++]);
        std::size_t vertices = token == GL_POINT_TOKEN ? 1 : 2;
        if (token == GL_POLYGON_TOKEN) vertices = static_cast<std::size_t>(buffer[i++]);
        for (; vertices > 0; --vertices, i += kPerVertex) {
            const glm::dvec2 window(buffer[i], buffer[i + 1]);
            for (std::size_t v = 0; v < scene.lit.size(); ++v) {
                const glm::dvec2 expected = (ndc(scene.lit[v]) * 0.5 + 0.5) * static_cast<double>(kWindow);
                if (glm::length(window - expected) > 0.5) continue;
                scene.fixed[v] = glm::dvec4(buffer[i + 3], buffer[i + 4], buffer[i + 5], buffer[i + 6]);
            }
        }
    }
}

// ---- Shaders ----

// The Draw as points where its vertices stand, in a tile of its own.
Draw as_points(const Scene& scene, const Viewport& tile) {
    Draw draw = scene.draw();
    if (!draws_polygons(draw.mode)) {
        draw.mode = kGL_POINTS;
        draw.indices.clear();
    }
    RasterState raster;  // nothing but the facing
    raster.front_face = draw.raster.front_face;
    raster.viewport = tile;
    raster.polygon_mode_front = raster.polygon_mode_back = kGL_POINT;
    draw.raster = raster;
    return draw;
}

void ask_shaders(std::vector<std::optional<Scene>>& scenes, programmable::Renderer& renderer) {
    Frame frame;
    frame.width = frame.height = kTiles * kTile;
    std::vector<Viewport> tiles;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const int n = static_cast<int>(i);
        tiles.push_back({n % kTiles * kTile, n / kTiles * kTile, kTile, kTile});
        if (scenes[i]) frame.items.emplace_back(as_points(*scenes[i], tiles.back()));
    }
    const Image image = renderer.render(frame, kGlsOwnModel);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        if (!scenes[i]) continue;
        for (std::size_t v = 0; v < scenes[i]->lit.size(); ++v) {
            const glm::dvec2 in_tile = (ndc(scenes[i]->lit[v]) * 0.5 + 0.5) * static_cast<double>(kTile);
            const int x = tiles[i].x + std::clamp(static_cast<int>(in_tile.x), 0, kTile - 1);
            const int y = tiles[i].y + std::clamp(static_cast<int>(in_tile.y), 0, kTile - 1);
            const Rgba& pixel = image.at(x, frame.height - 1 - y);
            scenes[i]->programmable[v] = glm::dvec4(pixel[0], pixel[1], pixel[2], pixel[3]);
        }
    }
}

// ---- The comparison ----

glm::dvec4 clamped(const glm::dvec4& color) { return glm::clamp(color, 0.0, 1.0); }

// The largest difference of a channel, relative to the magnitude.
void compare(PairFound& found, double bar, const Color& a, const Color& b, const glm::dvec4& magnitude,
             const std::string& where) {
    ++found.compared;
    if (!a || !b) {
        found.fails = found.misses = true;
        found.worst = 1;
        found.what = where + ": only one of the two shows this vertex";
        return;
    }
    for (int channel = 0; channel < 4; ++channel) {
        const double relative = std::abs((*a)[channel] - (*b)[channel]) / magnitude[channel];
        if (relative <= found.worst) continue;
        found.worst = std::isnan(relative) ? HUGE_VAL : relative;
        if (relative <= bar) continue;
        found.fails = true;
        found.what = fmt::format("{}, {}: {:.9g} and {:.9g}, {:.1e} of the terms' magnitude {:.3g}", where,
                                 std::array{"red", "green", "blue", "alpha"}.at(static_cast<std::size_t>(channel)),
                                 (*a)[channel], (*b)[channel], relative, magnitude[channel]);
    }
}

// softpipe's gl_FrontFacing is not that of the polygon where polygons are drawn as points (docs/architecture.md).
bool knows_faces_of_corners() { return !driver_name().starts_with("softpipe"); }

Found judge(const Scene& scene, const std::vector<std::string_view>& lifted) {
    Found found;
    const LeftOut left_out(*scene.commands, lifted);
    const bool back = shows_back(scene);
    const bool has_shaders =
        !scene.draw().lighting.light_model.two_side || !draws_polygons(scene.draw().mode) || knows_faces_of_corners();
    const bool is_sum = scene.draw().lighting.light_model.color_control != kGL_SINGLE_COLOR;
    for (std::size_t i = 0; i < scene.lit.size(); ++i) {
        const reference::LitVertex& lit = scene.lit[i];
        const glm::dvec4 primary = back ? lit.back_primary : lit.front_primary;
        const glm::dvec4 secondary = back ? lit.back_secondary : lit.front_secondary;
        const glm::dvec4 magnitude = glm::max(back ? lit.back_magnitude : lit.front_magnitude, glm::dvec4(1e-30));
        const glm::dvec4 at_least_1 = glm::max(magnitude, glm::dvec4(1));
        const glm::dvec4 sum = clamped(clamped(primary) + glm::dvec4(glm::dvec3(clamped(secondary)), 0));
        const std::string where = fmt::format("vertex {}, {} face", i, back ? "back" : "front");

        std::array<PairFound, kPairs> here;
        const auto of = [&](Pair pair) -> PairFound& { return here[static_cast<std::size_t>(pair)]; };
        const double bar_here = bar(scene.draw(), scene.draw().vertices[i]);
        compare(of(Pair::kFixedReference), bar_here, scene.fixed[i], primary, magnitude, where);
        compare(of(Pair::kProgrammableReference), bar_here, scene.programmable[i], sum, at_least_1, where);
        if (!is_sum) {  // feedback returns the primary colour alone
            const Color fixed = scene.fixed[i] ? Color(clamped(*scene.fixed[i])) : Color();
            compare(of(Pair::kFixedProgrammable), 2 * bar_here, fixed, scene.programmable[i], at_least_1, where);
        }

        const Departure* departure = left_out.at(scene.draw(), scene.draw().vertices[i]);
        if (departure) {
            LeftOutCount& count = found.left_out[departure];
            ++count.cases;
            count.differing += of(Pair::kFixedReference).fails;
        }
        for (std::size_t pair = 0; pair < kPairs; ++pair) {
            if (!has_shaders && pair != static_cast<std::size_t>(Pair::kFixedReference)) continue;
            if (departure && (has_fixed(pair) || departure->leaves != Leaves::kFixedFunction)) continue;
            PairFound& all = found.pairs[pair];
            all.compared += here[pair].compared;
            if (here[pair].fails && !all.fails) all.what = here[pair].what;
            all.misses = all.misses || here[pair].misses;
            all.fails = all.fails || here[pair].fails;
            all.worst = std::max(all.worst, here[pair].worst);
        }
    }
    return found;
}

}  // namespace

Floats::Floats(std::vector<std::string_view> lifted)
    : lifted_(std::move(lifted)),
      context_(make_offscreen_context(kTiles * kTile, kTiles * kTile, ColorBuffer::kFloat)) {
    renderer_.emplace();
}

Floats::~Floats() {
    context_->make_current();
    renderer_.reset();
}

std::vector<Found> Floats::compare(std::span<const std::shared_ptr<const CommandList>> commands) {
    context_->make_current();
    std::vector<Found> found(commands.size());
    std::vector<std::optional<Scene>> scenes;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        scenes.push_back(make_scene(commands[i], found[i].error));
        if (scenes.back()) ask_fixed(*scenes.back());
    }
    ask_shaders(scenes, *renderer_);
    for (std::size_t i = 0; i < commands.size(); ++i) {
        if (scenes[i]) found[i] = judge(*scenes[i], lifted_);
    }
    return found;
}

}  // namespace twinlight::fuzz
