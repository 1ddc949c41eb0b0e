// KeptMeshes: vertices are found again only if all of them are the same, and pictures do not change.
#include "render/programmable/kept_meshes.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "../hand_built_draws.h"
#include "app/session/camera.h"
#include "app/session/edits.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::programmable::kept_meshes_test {
namespace {

constexpr Options kLive = {{{.shading = {}}}, Tier::kAuto};

// Enough vertices and indices that the sampled hash skips some.
Draw strip() {
    Draw draw = square({});
    draw.mode = kGL_TRIANGLE_STRIP;
    draw.vertices.edit().clear();
    for (std::uint32_t i = 0; i < 100; ++i) {
        Vertex vertex;
        vertex.position_object = {i % 2 == 0 ? -1 : 1, i / 99.0 * 2 - 1, 0, 1};
        draw.vertices.edit().push_back(vertex);
        draw.indices.edit().push_back(i);
    }
    draw.materials.resize(2);
    return draw;
}

Frame frame_of(std::vector<Draw> draws) {
    Frame frame{.width = 4, .height = 4, .items = {}};
    for (Draw& draw : draws) {
        draw.raster.viewport = {0, 0, 4, 4};
        frame.items.emplace_back(std::move(draw));
    }
    return frame;
}

class Kept : public ::testing::Test {
  protected:
    MeshCounters counters() const { return renderer_.counters().meshes; }

    std::unique_ptr<OffscreenContext> context_ = make_offscreen_context(4, 4);
    Renderer renderer_;
};

TEST_F(Kept, VerticesAreSentOnceHoweverTheLightsAndMatricesMove) {
    for (int i = 0; i < 5; ++i) {
        LightingState lighting = shiny(32);
        lighting.lights[0].position_eye = {1 + 0.1 * i, 2, 3, 1};
        Draw draw = square(lighting);
        draw.eye_from_object[3].x = 0.01 * i;
        renderer_.draw(frame_of({draw}), kLive);
    }
    EXPECT_EQ(counters().made, 1u);
    EXPECT_EQ(counters().hits, 4u);
    EXPECT_GT(counters().bytes, 0u);
}

TEST_F(Kept, VerticesOfManyDrawsAreSentOnce) {
    Draw moved = square({});  // so that it is not joined with its neighbour
    moved.eye_from_object[3].x = 1;
    renderer_.draw(frame_of({square({}), moved, strip()}), kLive);
    EXPECT_EQ(counters().made, 2u);
    EXPECT_EQ(counters().hits, 1u);
}

TEST_F(Kept, BuffersAreFilledAnewForAProgramThatTakesOtherAttributes) {
    Draw draw = square(shiny(32));
    for (const bool lit : {true, false, true, false}) {
        draw.lighting.enabled = lit;
        renderer_.draw(frame_of({draw}), kLive);
    }
    EXPECT_EQ(counters().made, 2u);
    EXPECT_EQ(counters().hits, 2u);
}

TEST_F(Kept, NothingWhereFramesAreDrawnOnce) {
    for (const Tier tier : {Tier::kUniform, Tier::kBaked})
        renderer_.draw(frame_of({square({})}), {{{.shading = {}}}, tier});
    EXPECT_EQ(counters().made, 0u);
    EXPECT_EQ(counters().bytes, 0u);
}

Draw textured(float red) {
    Texture texture{.min_filter = kGL_NEAREST};
    texture.levels.push_back({.width = 4, .height = 4, .texels = std::vector<glm::vec4>(16, {red, 0, 0, 1})});
    Draw draw = square({});
    draw.texture.texture = std::make_shared<const Texture>(texture);  // State creates it again for each frame
    return draw;
}

TEST_F(Kept, TexturesAreSentOnceUntilATexelChanges) {
    const auto red = [&] { return read_pixels(4, 4).at(2, 2)[0]; };
    for (int i = 0; i < 3; ++i) renderer_.draw(frame_of({textured(1), textured(0.2F)}), kLive);
    EXPECT_EQ(renderer_.counters().textures, 2u);
    EXPECT_FLOAT_EQ(red(), 0.2F);
    renderer_.draw(frame_of({textured(0.2F), textured(1)}), kLive);
    EXPECT_EQ(renderer_.counters().textures, 2u);
    EXPECT_FLOAT_EQ(red(), 1);
    Draw changed = textured(1);
    Texture texture = *changed.texture.texture;
    texture.levels[0].texels[10].r = 0.6F;  // the third texel of the third row
    changed.texture.texture = std::make_shared<const Texture>(texture);
    changed.vertices.edit()[1].tex_coord = {1, 0, 0, 1};
    changed.vertices.edit()[2].tex_coord = {1, 1, 0, 1};
    changed.vertices.edit()[3].tex_coord = {0, 1, 0, 1};
    renderer_.draw(frame_of({textured(1), changed}), kLive);
    EXPECT_EQ(renderer_.counters().textures, 3u);
    EXPECT_FLOAT_EQ(read_pixels(4, 4).at(2, 1)[0], 0.6F);
}

TEST_F(Kept, TexturesThatAreTheSameInOneFrameAreEachTheirOwn) {
    for (int i = 0; i < 2; ++i) renderer_.draw(frame_of({textured(1), textured(1)}), kLive);
    EXPECT_EQ(renderer_.counters().textures, 2u);
}

// ---- Not the same ----

// Changes each number of a vertex by one bit.
TEST_F(Kept, OfEachVertexNoNumberChangesUnseen) {
    KeptMeshes kept(std::size_t{1} << 20);
    const Draw draw = strip();
    const auto known = kept.known(draw);
    ASSERT_EQ(kept.known(draw), known);
    const auto next = [](double& x) { x = std::nextafter(x, 7); };
    std::vector<std::function<void(Vertex&)>> changes = {
        [](Vertex& v) { v.edge_flag = !v.edge_flag; },
        [](Vertex& v) { v.material = 1; },
        [](Vertex& v) { v.position_object.z = -0.0; },
    };
    for (int i = 0; i < 4; ++i) {
        changes.emplace_back([=](Vertex& v) { next(v.position_object[i]); });
        changes.emplace_back([=](Vertex& v) { next(v.color[i]); });
        changes.emplace_back([=](Vertex& v) { next(v.tex_coord[i]); });
        if (i < 3) changes.emplace_back([=](Vertex& v) { next(v.normal_object[i]); });
    }
    for (std::size_t i = 0; i < draw.vertices.size(); ++i)
        for (std::size_t change = 0; change < changes.size(); ++change) {
            Draw changed = draw;
            changes[change](changed.vertices.edit()[i]);
            EXPECT_NE(kept.known(changed), known) << "vertex " << i << ", change " << change;
        }
    for (std::size_t i = 0; i < draw.indices.size(); ++i) {
        Draw changed = draw;
        changed.indices.edit()[i] ^= 1;
        EXPECT_NE(kept.known(changed), known) << "index " << i;
    }
    EXPECT_EQ(kept.known(draw), known);
}

TEST_F(Kept, NeitherTheModeNorTheMaterialsOfVerticesChangeUnseen) {
    KeptMeshes kept(std::size_t{1} << 20);
    const auto known = kept.known(strip());
    Draw draw = strip();
    draw.mode = kGL_QUAD_STRIP;
    EXPECT_NE(kept.known(draw), known);
    draw = strip();
    draw.materials[1].back.shininess = 1;
    EXPECT_NE(kept.known(draw), known);
    draw = strip();
    draw.materials.pop_back();
    EXPECT_NE(kept.known(draw), known);
    draw = strip();
    draw.indices.edit().clear();
    EXPECT_NE(kept.known(draw), known);
}

TEST_F(Kept, AVertexThatChangesIsDrawnAsItIs) {
    Draw draw = strip();
    for (Vertex& vertex : draw.vertices.edit()) vertex.color = {0, 1, 0, 1};
    for (int i = 0; i < 10; ++i) renderer_.draw(frame_of({draw}), kLive);
    const auto green_of_the_top = [&] { return read_pixels(4, 4).at(2, 0)[1]; };
    ASSERT_EQ(green_of_the_top(), 1);
    draw.vertices.edit().back().color = {0, 0, 0, 1};
    draw.vertices.edit()[98].color = {0, 0, 0, 1};
    for (std::size_t i = 70; i < 98; ++i)
        draw.vertices.edit()[i].position_object.y = draw.vertices.edit()[70].position_object.y;
    renderer_.draw(frame_of({draw}), kLive);
    EXPECT_LT(green_of_the_top(), 0.5);
}

// ---- The limit ----

// Each has a state of its own, so that neighbours are not joined.
Draw square_at(double x) {
    Draw draw = square({});
    draw.eye_from_object[3].y = x;
    for (Vertex& vertex : draw.vertices.edit()) vertex.position_object.x += x;
    return draw;
}

class KeptUpToALimit : public Kept {
  protected:
    // Room for two squares.
    static std::size_t room_for_two() {
        Renderer renderer;
        renderer.draw(frame_of({square({})}), kLive);
        return 2 * renderer.counters().meshes.bytes;
    }
    Renderer small_{{.mesh_bytes = room_for_two()}};
    MeshCounters counters() const { return small_.counters().meshes; }
    void draw(const std::vector<Draw>& draws, int times = 2) {
        for (int i = 0; i < times; ++i) {
            small_.draw(frame_of(draws), kLive);
            EXPECT_LE(counters().bytes, room_for_two());
        }
    }
};

TEST_F(KeptUpToALimit, ThoseGoThatWereNotDrawnForTheLongestTime) {
    draw({square_at(1)});
    draw({square_at(2)});
    draw({square_at(1)});
    draw({square_at(3)});
    EXPECT_EQ(counters().evicted, 1u);
    EXPECT_EQ(counters().made, 3u);
    draw({square_at(1)});
    EXPECT_EQ(counters().made, 3u);
    draw({square_at(2)});
    EXPECT_EQ(counters().made, 4u);
}

TEST_F(KeptUpToALimit, AFrameOfMoreKeepsWhatHasRoom) {
    draw({square_at(1), square_at(2), square_at(3)}, 3);
    EXPECT_EQ(counters().hits, 4u);
    EXPECT_EQ(counters().made, 5u);
    EXPECT_EQ(counters().evicted, 0u);
}

TEST_F(Kept, ButNotWhatOneFrameAloneHasDrawn) {
    const auto draw = [&](int i) { renderer_.draw(frame_of({square_at(0), square_at(0.1 * i)}), kLive); };
    for (int i = 1; i <= 2; ++i) draw(i);
    const std::size_t of_three = counters().bytes;
    for (int i = 3; i <= 50; ++i) draw(i);
    EXPECT_LE(counters().bytes, of_three);
    EXPECT_EQ(counters().evicted, 49u);
    EXPECT_EQ(counters().hits, 49u);
}

// ---- The same pictures ----

TEST(KeptPictures, OfTheBuiltInScenesAreTheSameBitByBit) {
    constexpr int kWidth = 160, kHeight = 120;
    const auto context = make_offscreen_context(kWidth, kHeight);
    for (const EmbeddedFile& file : kSceneFiles) {
        const CommandList scene = read_built_in(file);
        Renderer keeps, forgets({.mesh_bytes = 0});
        for (int i = 0; i < 8; ++i) {
            session::CameraMove move;
            move.yaw_deg = i < 4 ? 7 * i : 21;  // rotates, then stops
            CommandList seen = session::with_camera_moved(scene, move, {0, 0, -5});
            if (i % 4 == 2)
                seen = session::with_inserted(
                    seen, 0, session::new_command(CommandId::glPolygonMode, {kGL_FRONT_AND_BACK, kGL_LINE}));
            const Frame frame = make_frame(seen, {.width = kWidth, .height = kHeight});
            EXPECT_EQ(keeps.render(frame, kLive).pixels, forgets.render(frame, kLive).pixels)
                << file.name << ", frame " << i;
        }
        EXPECT_GT(keeps.counters().meshes.hits, 0u) << file.name;
        EXPECT_EQ(forgets.counters().meshes.hits, 0u) << file.name;
    }
}

}  // namespace
}  // namespace twinlight::programmable::kept_meshes_test
