// Joined Draws: which neighbours have one state, and that pictures of them are those of the Draws one by one.
#include "render/programmable/joined_draws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../hand_built_draws.h"
#include "base/image/difference.h"
#include "judge/fuzz/fuzzer.h"
#include "render/programmable/numbers/draw_values.h"
#include "scene/command/text.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::programmable::joined_draws_test {
namespace {

constexpr Options kWithConstants = {{{.shading = {}}}, Tier::kBaked};  // Draws are not placed then
constexpr Options kLive = {{{.shading = {}}}, Tier::kAuto};

LightingState lit() {
    LightingState lighting = dark();
    lighting.front.diffuse = {0.2, 0.4, 0.6, 1};
    return lighting;
}

TEST(JoinedDraws, DifferInTheirVerticesOnly) {
    const Draw draw = square(lit());
    Draw other = draw;
    other.vertices.edit()[0].color = {0, 1, 0, 1};
    other.mode = kGL_TRIANGLE_FAN;
    other.place.line = 7;
    EXPECT_TRUE(have_one_state(draw, other));
    const std::vector<std::function<void(Draw&)>> changes = {
        [](Draw& d) { d.eye_from_object[3].x = 1; },
        [](Draw& d) { d.clip_from_eye[0][0] = 2; },
        [](Draw& d) { d.lighting.front.diffuse.r = 1; },
        [](Draw& d) { d.lighting.back.shininess = 1; },
        [](Draw& d) { d.lighting.lights[3].position_eye.x = 1; },
        [](Draw& d) { d.lighting.light_model.ambient.r = 1; },
        [](Draw& d) { d.lighting.color_material.enabled = true; },
        [](Draw& d) { d.lighting.normalize = true; },
        [](Draw& d) { d.lighting.shade_model = kGL_FLAT; },
        [](Draw& d) { d.lighting.enabled = false; },
        [](Draw& d) { d.raster.line_width = 2; },
        [](Draw& d) { d.raster.clip_planes_eye[2] = glm::dvec4(1); },
        [](Draw& d) { d.texture.texture = std::make_shared<const Texture>(); },
        [](Draw& d) { d.fog.enabled = true; },
        [](Draw& d) { d.fragment.blend = true; },
        [](Draw& d) { d.materials.resize(1); },
        [](Draw& d) {
            d.indices = {0, 1, 2};
        },
        [](Draw& d) { d.mode = kGL_LINES; },
        [](Draw& d) { d.mode = kGL_POINTS; },
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        other = draw;
        changes[i](other);
        EXPECT_FALSE(have_one_state(draw, other)) << "change " << i;
    }
    Draw lines = draw, points = draw;
    lines.mode = kGL_LINES;
    points.mode = kGL_POINTS;
    EXPECT_FALSE(have_one_state(lines, points));
}

// State numbers only save the comparison.
void expect_right_state_numbers(const Frame& frame, std::size_t& equal) {
    const std::vector<const Draw*> draws = frame.draws();
    for (std::size_t i = 1; i < draws.size(); ++i) {
        Draw a = *draws[i - 1], b = *draws[i];
        if (a.state_number == 0 || a.state_number != b.state_number) continue;
        ++equal;
        const bool is_one = have_one_state(a, b);
        a.state_number = b.state_number = 0;
        EXPECT_EQ(have_one_state(a, b), is_one) << "Draw " << i + 1 << ", " << b.place.str();
    }
}

TEST(JoinedDraws, HaveTheStateOfAnotherWithTheSameNumber) {
    std::size_t equal = 0;
    for (const EmbeddedFile& file : kSceneFiles)
        expect_right_state_numbers(
            make_scene(load_commands(std::string(file.name.substr(0, file.name.rfind('.')))), {}).frame, equal);
    for (const auto& folder : std::filesystem::directory_iterator("tests/traces"))
        if (std::filesystem::exists(folder.path() / "dump.txt"))
            expect_right_state_numbers(make_recorded_frame(load_recording(folder.path() / "dump.txt"), {}).scene.frame,
                                       equal);
    for (int state = 0; state < 500; ++state)
        expect_right_state_numbers(make_frame(fuzz::random_scene({{.seed = 20}}, state), {.width = 64, .height = 64}),
                                   equal);
    EXPECT_GT(equal, 1000u);
}

TEST(JoinedDraws, GetNewStateNumbersFromCommandsThatChangeTheirState) {
    const auto numbers = [](const std::string& between) {
        const Frame frame = make_frame(
            read_scene("glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glBegin(GL_POINTS); glVertex3f(0, 0, 0); glEnd();" +
                           between + "glBegin(GL_POINTS); glVertex3f(0.5, 0, 0); glEnd();",
                       "two", "two"),
            {.width = 8, .height = 8});
        return std::pair(frame.draws().at(0)->state_number, frame.draws().at(1)->state_number);
    };
    for (const char* const keeps : {"", "glColor3f(1, 0, 0);", "glNormal3f(0, 1, 0); glTexCoord2f(1, 0);"}) {
        const auto [first, second] = numbers(keeps);
        EXPECT_EQ(first, second) << keeps;
        EXPECT_NE(first, 0u);
    }
    for (const char* const changes :
         {"glTranslatef(1, 0, 0);", "glMaterialf(GL_FRONT, GL_SHININESS, 3);", "glShadeModel(GL_FLAT);",
          "glEnable(GL_COLOR_MATERIAL); glColor3f(1, 0, 0);", "glFogf(GL_FOG_DENSITY, 2);"}) {
        const auto [first, second] = numbers(changes);
        EXPECT_NE(first, second) << changes;
    }
}

// GL has no array of edge flags for shaders.
TEST(JoinedDraws, AsEdgesAreOneUnlessAnEdgeFlagIsOff) {
    Draw draw = square(lit());
    draw.raster.polygon_mode_back = kGL_LINE;
    EXPECT_TRUE(have_one_state(draw, draw));
    Draw other = draw;
    other.vertices.edit()[2].edge_flag = false;
    EXPECT_FALSE(have_one_state(draw, other));
    EXPECT_FALSE(have_one_state(other, draw));
}

// 2.14.3: glColor before each object changes the material that the state has, too.
TEST(JoinedDraws, MayDifferInWhatTheVerticesColoursReplace) {
    Draw draw = square(lit());
    draw.lighting.color_material = {.enabled = true, .face = kGL_FRONT, .mode = kGL_DIFFUSE};
    Draw other = draw;
    other.lighting.front.diffuse = {1, 0, 0, 1};
    EXPECT_TRUE(have_one_state(draw, other));
    other.lighting.front.specular = {1, 0, 0, 1};
    EXPECT_FALSE(have_one_state(draw, other));
    other = draw;
    other.lighting.back.diffuse = {1, 0, 0, 1};
    EXPECT_FALSE(have_one_state(draw, other)) << "only the front face tracks the colour";
}

TEST(JoinedDraws, WithoutLightingHaveOneStateWhateverTheLights) {
    Draw draw = square(lit()), other = draw;
    draw.lighting.enabled = other.lighting.enabled = false;
    other.lighting.front.diffuse = {1, 0, 0, 1};
    other.lighting.lights[0].enabled = false;
    EXPECT_TRUE(have_one_state(draw, other));
}

TEST(JoinedDraws, CountTheirIndicesOn) {
    Draw first = square(lit()), second = square(lit());
    first.indices = {0, 1, 2, 3};
    second.indices = {3, 2, 1, 0};
    const Draw* const run[] = {&first, &second};
    const JoinedDraws all = joined(run);
    EXPECT_EQ(all.draw.vertices.size(), 8u);
    EXPECT_EQ(all.draw.indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 7, 6, 5, 4}));
    EXPECT_EQ(all.parts, (std::vector<ElementsPart>{{kGL_QUADS, 4, 4}, {kGL_QUADS, 4, 4}}));
}

// ---- Pictures ----

constexpr int kSize = 32;

// A row of polygons, one Draw each, in every mode that draws polygons, some with vertices left over.
Frame row_of_polygons(bool with_indices) {
    struct Kind {
        Enum mode;
        int vertices;
    };
    constexpr Kind kKinds[] = {{kGL_TRIANGLES, 3}, {kGL_TRIANGLES, 5},    {kGL_TRIANGLES, 3}, {kGL_TRIANGLE_STRIP, 4},
                               {kGL_QUADS, 4},     {kGL_QUADS, 6},        {kGL_QUADS, 4},     {kGL_QUAD_STRIP, 4},
                               {kGL_POLYGON, 5},   {kGL_TRIANGLE_FAN, 5}, {kGL_POLYGON, 4}};
    Frame frame{.width = kSize, .height = kSize, .items = {}};
    double left = -1;
    for (const Kind& kind : kKinds) {
        Draw draw = square(lit());
        draw.raster.viewport = {0, 0, kSize, kSize};
        draw.lighting.lights[0].position_eye = {0.3, 0.5, 2, 1};
        draw.mode = kind.mode;
        draw.vertices.edit().resize(static_cast<std::size_t>(kind.vertices));
        const bool zigzag = kind.mode == kGL_TRIANGLE_STRIP || kind.mode == kGL_QUAD_STRIP;
        for (int i = 0; i < kind.vertices; ++i) {
            const int corner = i % 4;
            const double x = zigzag ? corner / 2 : (corner == 1 || corner == 2);
            const double y = zigzag ? corner % 2 : corner / 2;
            Vertex& vertex = draw.vertices.edit()[static_cast<std::size_t>(i)];
            vertex.position_object = {left + 0.15 * x + 0.01 * i, 1.6 * y - 0.8, 0, 1};
            vertex.normal_object = {0.1 * i, 0, 1};
            if (with_indices) draw.indices.edit().push_back(static_cast<std::uint32_t>(i));
        }
        left += 0.18;
        frame.items.emplace_back(std::move(draw));
    }
    return frame;
}

// With a Clear of nothing between the Draws, which are then drawn one by one.
Frame one_by_one(const Frame& frame) {
    Frame apart = frame;
    apart.items.clear();
    for (const auto& item : frame.items) {
        apart.items.push_back(item);
        apart.items.emplace_back(Clear{});
    }
    return apart;
}

double largest_difference(const Image& a, const Image& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            largest = std::max<double>(largest, std::abs(a.pixels[i][c] - b.pixels[i][c]));
    return largest;
}

class JoinedPictures : public ::testing::TestWithParam<bool> {};

TEST_P(JoinedPictures, AreThoseOfTheDrawsOneByOneBitByBit) {
    const auto context = make_offscreen_context(kSize, kSize, ColorBuffer::kFloat);
    const Frame frame = row_of_polygons(GetParam());
    Renderer separates;
    const Image apart = separates.render(one_by_one(frame), {});
    EXPECT_EQ(separates.counters().made + separates.counters().hits, frame.items.size());
    for (const Options& options : {Options{}, kLive}) {
        Renderer joins;
        EXPECT_EQ(joins.render(frame, options).pixels, apart.pixels);
        EXPECT_EQ(joins.counters().made + joins.counters().hits, 1u) << "one program is used once";
    }
    std::size_t covered = 0;
    for (const Rgba& pixel : apart.pixels) covered += pixel[2] > 0;
    EXPECT_GT(covered, apart.pixels.size() / 3);
}

// Frames of few Draws that are drawn once plan each Draw by itself, so that pictures do not depend on a Draw's neighbours.
TEST(JoinedDraws, WithPlansThatDifferAreDrawnOneByOneInFramesThatAreDrawnOnce) {
    const auto context = make_offscreen_context(kSize, kSize, ColorBuffer::kFloat);
    Frame frame = row_of_polygons(false);
    frame.items.resize(3);
    for (Vertex& vertex : std::get<Draw>(frame.items[1]).vertices.edit()) vertex.normal_object = {0, 0, -1};  // unlit
    Renderer once;
    EXPECT_EQ(once.render(frame, {}).pixels, once.render(one_by_one(frame), {}).pixels);
    EXPECT_EQ(once.counters().made + once.counters().hits, 6u);
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutIndices, JoinedPictures, ::testing::Bool());

TEST(JoinedDraws, EndWhereAClearComesBetween) {
    const auto context = make_offscreen_context(kSize, kSize, ColorBuffer::kFloat);
    Frame frame = row_of_polygons(false);
    frame.items.insert(frame.items.begin() + 5, Clear{.color = true});
    Renderer joins, separates;
    EXPECT_EQ(joins.render(frame, kLive).pixels, separates.render(one_by_one(frame), {}).pixels);
    EXPECT_EQ(joins.counters().made + joins.counters().hits, 2u);
}

TEST(JoinedDraws, EndWhereTheyGetLong) {
    const auto context = make_offscreen_context(kSize, kSize);
    Frame frame = row_of_polygons(false);
    Draw large = std::get<Draw>(frame.items.front());
    large.vertices.edit().resize(kMostJoinedVertices, large.vertices.front());
    frame.items = {large, frame.items[0], frame.items[2]};
    Renderer joins;
    joins.draw(frame, kLive);
    EXPECT_EQ(joins.counters().made + joins.counters().hits, 2u);
}

// Under Tier::kAuto, and in frames of 40 Draws or more, they have one plan, so a light that is too faint for one of them may be
// in for all.
TEST(JoinedDraws, OfTheBuiltInScenesDifferByOneCodeAtMost) {
    constexpr int kWidth = 160, kHeight = 120;
    const auto context = make_offscreen_context(kWidth, kHeight);
    int with_few = 0, with_many = 0;
    for (const EmbeddedFile& file : kSceneFiles) {
        const std::string name(file.name.substr(0, file.name.rfind('.')));
        const Frame frame = make_scene(load_commands(name), {.width = kWidth, .height = kHeight}).frame;
        Renderer renderer;
        const Image live = renderer.render(frame, kLive), once = renderer.render(frame, {});
        EXPECT_LE(largest_difference(live, once), 1.01 / 255) << file.name;
        const bool has_many = frame.draws().size() >= 40;
        ++(has_many ? with_many : with_few);
        if (has_many) continue;
        EXPECT_EQ(once.pixels, renderer.render(one_by_one(frame), {}).pixels) << file.name;
    }
    EXPECT_GT(with_few, 5);
    EXPECT_GT(with_many, 5);
}

// ---- Placed Draws ----

TEST(PlacedDraws, MayDifferInTheirPlacesAndMaterials) {
    const Draw draw = square(lit());
    Draw other = draw;
    other.eye_from_object[3].x = 1;
    other.lighting.front.diffuse.r = 1;
    other.materials.resize(2);
    EXPECT_TRUE(have_one_state_when_placed(draw, other));
    other.lighting.lights[3].position_eye.x = 1;
    EXPECT_FALSE(have_one_state_when_placed(draw, other));
}

TEST(PlacedDraws, AreSmall) {
    Draw draw = square(lit());
    const Draw* const run[] = {&draw, &draw};
    EXPECT_TRUE(may_be_placed(run));
    draw.vertices.edit().resize(kMostPlacedVertices / 2 + 1);
    EXPECT_FALSE(may_be_placed(run));
}

// By hand: what eye coordinates and the transposed inverse make of a point and a normal.
TEST(PlacedDraws, AreInEyeCoordinatesWithTheirMaterials) {
    Draw first = square(lit()), second = square(lit()), third = square(lit());
    second.eye_from_object = glm::dmat4(2, 0, 0, 0, 0, 4, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1);
    second.vertices.edit()[0].position_object = {1, 2, 3, 1};
    second.vertices.edit()[0].normal_object = {1, 1, 1};
    second.lighting.front.shininess = 7;
    const Draw* const draws[] = {&first, &second, &third};
    const JoinedDraws all = placed_together(draws);
    EXPECT_EQ(all.draw.eye_from_object, glm::dmat4(1));
    EXPECT_EQ(all.draw.vertices[4].position_object, glm::dvec4(12, 28, 33, 1));
    EXPECT_EQ(all.draw.vertices[4].normal_object, glm::dvec3(0.5, 0.25, 1));
    ASSERT_EQ(all.draw.materials.size(), 2u);
    EXPECT_EQ(all.draw.materials[all.draw.vertices[4].material].front.shininess, 7);
    EXPECT_EQ(all.draw.vertices[8].material, all.draw.vertices[0].material);
    EXPECT_EQ(all.parts, (std::vector<ElementsPart>(3, {kGL_QUADS, 4, 0})));

    second.lighting.rescale_normal = true;  // the third row of the inverse is 0, 0, 1: a factor of 1
    second.eye_from_object[2][2] = 8;       // of 8
    const Draw* const rescaled = &second;
    EXPECT_EQ(placed_together({&rescaled, 1}).draw.vertices[0].normal_object, glm::dvec3(4, 2, 1));
}

// Many squares, each at its own place, turned, scaled and mirrored, with its own material.
Frame many_places() {
    Frame frame{.width = kSize, .height = kSize, .items = {}};
    for (int i = 0; i < 49; ++i) {
        Draw draw = square(lit());
        draw.raster.viewport = {0, 0, kSize, kSize};
        draw.lighting.lights[0].position_eye = {0.3, 0.5, 2, 1};
        draw.lighting.light_model.two_side = true;
        draw.lighting.normalize = i / 12 % 2 == 0;
        draw.lighting.rescale_normal = i >= 36;
        draw.lighting.front.diffuse = {0.2 * (i % 5), 0.4, 0.1 * (i % 7), 1};
        draw.lighting.front.specular = {0.3, 0.1 * (i % 3), 0, 1};
        draw.lighting.front.shininess = i % 4;
        const double size = 0.1 + 0.001 * i, angle = 0.1 * i, turn = i % 6 == 0 ? -1 : 1;
        draw.eye_from_object = glm::dmat4(size * std::cos(angle), size * std::sin(angle), 0, 0,
                                          -turn * size * std::sin(angle), turn * size * std::cos(angle), 0, 0, 0, 0,
                                          size, 0, -0.9 + 0.3 * (i % 7), -0.9 + 0.3 * (i / 7), 0, 1);
        frame.items.emplace_back(std::move(draw));
    }
    return frame;
}

TEST(PlacedDraws, GiveThePictureOfTheDrawsOneByOne) {
    const auto context = make_offscreen_context(kSize, kSize);
    const Frame frame = many_places();
    Renderer live, separate;
    live.draw(frame, kLive);
    const Image picture = read_pixels(kSize, kSize);
    const Image apart = separate.render(one_by_one(frame), kWithConstants);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        covered += apart.pixels[i][1] > 0;
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(picture.pixels[i][c], apart.pixels[i][c], 1.01 / 255) << i;
    }
    EXPECT_GT(covered, apart.pixels.size() / 2);
    EXPECT_EQ(live.counters().made + live.counters().hits, 5u)
        << "normals that are made unit in another way end a group";
}

// Overlapping squares and outlines that are blended, so that their order shows, in more states than are placed together.
TEST(PlacedDraws, KeepTheirOrderThoughThoseOfOneStateAreUploadedTogether) {
    const auto context = make_offscreen_context(kSize, kSize);
    Frame frame = many_places();
    for (std::size_t i = 0; i < frame.items.size(); ++i) {
        Draw& draw = std::get<Draw>(frame.items[i]);
        draw.lighting.normalize = draw.lighting.rescale_normal = false;
        draw.lighting.front.diffuse.a = 0.7;
        draw.eye_from_object = glm::dmat4(0.5) * draw.eye_from_object;
        draw.eye_from_object[3] = {0.04 * static_cast<double>(i % 7), 0.05 * static_cast<double>(i % 5), 0, 1};
        if (i % 2 == 1) draw.mode = kGL_LINE_LOOP;
        if (i >= 20) draw.raster.line_width = static_cast<double>(i % 11 + 1) / 2;
        draw.fragment.blend = true;
        draw.fragment.blend_src = kGL_SRC_ALPHA;
        draw.fragment.blend_dst = kGL_ONE_MINUS_SRC_ALPHA;
    }
    Renderer live, separate;
    live.draw(frame, kLive);
    const Image picture = read_pixels(kSize, kSize);
    const Image apart = separate.render(one_by_one(frame), kWithConstants);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(picture.pixels[i][c], apart.pixels[i][c], 1.01 / 255) << i;
    EXPECT_EQ(live.counters().made + live.counters().hits, frame.items.size()) << "no neighbours have one state";
    Frame reversed = frame;
    std::ranges::reverse(reversed.items);
    live.draw(reversed, kLive);
    EXPECT_NE(read_pixels(kSize, kSize).pixels, picture.pixels) << "the order does not show";
}

// The scene's second pass adds light where depths are equal. It generates texture coordinates, so it cannot be placed.
TEST(PlacedDraws, AreNoneOfThoseThatAreDrawnAgainWhereDepthsAreEqual) {
    constexpr int kWidth = 160, kHeight = 120;
    const auto context = make_offscreen_context(kWidth, kHeight);
    const Frame frame = make_scene(load_commands("shadow-map", "2"), {.width = kWidth, .height = kHeight}).frame;
    ASSERT_GE(frame.draws().size(), 40u);
    const Image apart = Renderer().render(frame, kWithConstants);
    for (const Options& options : {Options{}, kLive}) {
        const Image picture = Renderer().render(frame, options);
        std::size_t differing = 0;
        for (std::size_t i = 0; i < picture.pixels.size(); ++i)
            differing += std::abs(picture.pixels[i][0] - apart.pixels[i][0]) > 0.03F;
        EXPECT_LT(differing, picture.pixels.size() / 100);
    }
}

// ---- Draws with one plan ----

TEST(PlansByState, AreSharedByDrawsWhoseFactsDecideTheSame) {
    Draw draw = square(lit());
    const VertexFacts facts = vertex_facts(draw);
    Draw other = draw;
    for (Vertex& vertex : other.vertices.edit()) vertex.position_object += glm::dvec4(3, 2, 1, 0);
    EXPECT_TRUE(have_one_plan_by_state(facts, vertex_facts(other)));
    const std::vector<std::function<void(Vertex&)>> changes = {
        [](Vertex& v) { v.position_object.w = 2; }, [](Vertex& v) { v.position_object.w = 0; },
        [](Vertex& v) { v.normal_object.x = 1; },   [](Vertex& v) { v.color.r = 0.5; },
        [](Vertex& v) { v.tex_coord.q = 2; },
    };
    for (const auto& change : changes) {
        other = draw;
        change(other.vertices.edit()[0]);
        EXPECT_FALSE(have_one_plan_by_state(facts, vertex_facts(other)));
    }
    other = draw;
    other.materials.resize(1);
    EXPECT_FALSE(have_one_plan_by_state(facts, vertex_facts(other)));
}

// The attenuation of a tiny scene is counted in another unit of length.
TEST(PlansByState, GiveEachDrawItsOwnUnitOfLength) {
    Draw first = square(lit());
    first.lighting.lights[0].position_eye = {0, 0, 1e-7, 1};
    first.lighting.lights[0].linear_attenuation = 1;
    Draw tiny = first;
    first.eye_from_object[3].z = -4;
    for (int i = 0; i < 3; ++i) tiny.eye_from_object[i] *= 1e-8;
    PlanOptions by_state{};
    by_state.for_any_pose = true;
    ASSERT_TRUE(have_one_state_anywhere(first, tiny));
    const Plan plan = plan_effects(first, by_state);
    const DrawProgram like = draw_program(first, plan, false), alone = draw_program(tiny, plan, false);
    ASSERT_EQ(like.code.form, alone.code.form);
    ASSERT_NE(like.of_state.unit, alone.of_state.unit);
    EXPECT_EQ(draw_program(tiny, plan, false, &like).numbers, alone.numbers);
}

// Draws of random scenes at other places, larger and smaller: what is shared is what would be computed again.
TEST(PlansByState, GiveTheProgramsAndNumbersThatEachDrawWouldGet) {
    const std::vector<glm::dmat4> moves = {
        glm::dmat4(1),
        glm::dmat4(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0.3, 0.2, -4, 1),
        glm::dmat4(2, 0, 0, 0, 0, 3, 0, 0, 0, 1, 0.5, 0, 0, 0, 0, 1),
        glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1e12, 1),
        glm::dmat4(1e-12, 0, 0, 0, 0, 1e-12, 0, 0, 0, 0, 1e-12, 0, 0, 0, 0, 1),
        glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1e6, 0, 0, 1),
    };
    PlanOptions by_state{};
    by_state.for_any_pose = true;
    std::size_t with_colors = 0, with_lights = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const Frame frame = make_frame(fuzz::random_scene({}, seed), {.width = 64, .height = 48});
        for (const Draw* draw : frame.draws()) {
            if (!keeps_w(draw->eye_from_object) || draw->count() == 0) continue;
            const Plan known = plan_effects(*draw, by_state);
            const DrawProgram like = draw_program(*draw, known, false);
            for (const glm::dmat4& move : moves) {
                Draw other = *draw;
                other.eye_from_object = move * draw->eye_from_object;
                other.vertices.edit()[0].position_object.x *= 2;
                if (!have_one_state_anywhere(*draw, other)) continue;
                const Plan fresh = plan_effects(other, by_state);
                if (!have_one_plan_by_state(known.vertices, fresh.vertices)) continue;
                Plan shared = known;
                shared.vertices = fresh.vertices;
                EXPECT_EQ(shared.effects, fresh.effects) << seed;
                const DrawProgram alone = draw_program(other, fresh, false);
                const DrawProgram with = draw_program(other, shared, false, &like);
                EXPECT_EQ(with.code.form, alone.code.form) << seed;
                EXPECT_EQ(with.numbers, alone.numbers) << seed;
                with_colors += alone.code.effects.lighting;
                with_lights += alone.code.effects.lighting && !alone.code.form.wide_range &&
                               alone.of_state.unit == like.of_state.unit;
            }
        }
    }
    EXPECT_GT(with_colors, 100u);
    EXPECT_GT(with_lights, 50u);
}

}  // namespace
}  // namespace twinlight::programmable::joined_draws_test
