// Form: what of a program's code the numbers of a Draw decide, beside its effects.
#pragma once

#include <compare>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "render/effect/plan.h"

namespace twinlight::programmable {

// An exact surface in the place of a mesh (surface_values.h): what rays meet, and what is made of where they meet it.
enum class SurfaceKind : std::uint8_t { kNone, kSphere, kFrustum, kDisk, kTorus };
struct SurfaceForm {
    SurfaceKind kind = SurfaceKind::kNone;
    bool inside = false;     // normals look inwards
    bool sector = false;     // a disk between two angles
    bool tex_coord = false;  // texture coordinates of its own are called for
    bool near_far = false;   // the near or the far plane may cut it, or the eye be in it
    bool culls = false;
    bool depth = false;    // the depth test asks for it
    bool offset = false;   // glPolygonOffset
    bool nearest = false;  // of a ray's points the nearest alone is drawn; else that of one number

    friend auto operator<=>(const SurfaceForm&, const SurfaceForm&) = default;  // NOLINT
};

// NOLINT below: clang-tidy takes a defaulted <=> for a null pointer.
struct Form {
    // The vertices are lit in object coordinates, to which the lights are brought once: where the modelview matrix keeps
    // angles, no vertex's position and normal need be brought to the lights.
    bool object_space = false;
    // Every sum in the one order of --precise (precise.h). Then object_space follows the driver.
    bool precise = false;
    bool rescale = false;    // precise: the normals are multiplied by GL_RESCALE_NORMAL's factor
    bool position_w = true;  // w of a vertex's position may be other than 1
    // The last lights of the effects, as many as these, stand for many that differ in numbers alone: the text goes through
    // them in a loop, over arrays of these lengths.
    std::vector<int> loops;
    SurfaceForm surface{};

    friend auto operator<=>(const Form&, const Form&) = default;  // NOLINT
};

// What a Draw's program is made from.
struct Code {
    EffectSet effects;  // the plan's, with one light for all that a loop goes through
    Form form;
    std::vector<std::vector<std::size_t>> lights;  // for each of the effects', which of plan.lights
    std::optional<glm::dvec3> origin_object;       // upload_origin(): what uploaded positions are relative to
};

// Where the object and the camera are far from the object's origin, floats cannot hold both the vertices' coordinates and their
// distance from the eye, so vertices are uploaded relative to a place among them, subtracted in double. Gives that place, in object
// coordinates; nothing where vertices stay as they are. `facts` are the Draw's.
std::optional<glm::dvec3> upload_origin(const Draw& draw, const VertexFacts& facts);

Code code_for(const Draw& draw, const Plan& plan, const SurfaceForm& surface = {});

// Of lights with equal facts more than these are gone through in a loop: its text does not grow with them. On llvmpipe a
// light in the loop takes four times as long as one that is written out, whose compilation takes some 4 ms instead.
inline constexpr std::size_t kMostWrittenOut = 32;

// By what factor the modelview matrix scales lengths, if it turns, mirrors and scales the same in all directions (to
// the precision of floats) and nothing else, or 0.
double similarity_scale(const glm::dmat4& eye_from_object);

}  // namespace twinlight::programmable
