// Form: the parts of a program's code that depend on a Draw's numbers, in addition to its effects.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <vector>

#include "render/effect/plan.h"

namespace twinlight::programmable {

// An exact surface drawn instead of a mesh (surface_values.h): its kind and what the shader does at the points that
// rays hit.
enum class SurfaceKind : std::uint8_t { kNone, kSphere, kFrustum, kDisk, kTorus };
struct SurfaceForm {
    SurfaceKind kind = SurfaceKind::kNone;
    bool inside = false;     // normals look inwards
    bool sector = false;     // a disk between two angles
    bool tex_coord = false;  // the shader computes the surface's texture coordinates
    bool near_far = false;   // the near or far plane may cut it, or the eye may be inside
    bool culls = false;
    bool depth = false;    // the depth test is on, so the shader writes the depth
    bool offset = false;   // glPolygonOffset
    bool nearest = false;  // draws only the nearest point of a ray; otherwise the point with number u_point_number

    friend auto operator<=>(const SurfaceForm&, const SurfaceForm&) = default;  // NOLINT
};

// Vertices are corners of rectangles about lines or points; line_attributes() has what the corners need.
enum class Rectangles : std::uint8_t { kNone, kLines, kPoints };

// The dialect of a program's text. The later two lack parts of OpenGL 2.1, which the program does instead: see Form.
enum class Glsl : std::uint8_t { k130, k330, k300es };

// Shaders to keep (kept/kept_files.h): their uniforms are GL's state with GL's names, without the prefix gl_.
struct KeptForm {
    std::vector<int> lights;       // for each light of the effects: its number in GL
    int light_count = 0;           // the length of the array LightSource
    std::vector<int> clip_planes;  // the numbers of the enabled ones
    std::map<std::size_t, std::array<bool, 4>>
        eye_planes;                   // of each texture unit's generated coordinates: GL_EYE_LINEAR
    bool rescales_generated = false;  // GL_RESCALE_NORMAL, for those generated from the normal

    friend auto operator<=>(const KeptForm&, const KeptForm&) = default;  // NOLINT
};

// NOLINT below: clang-tidy takes a defaulted <=> for a null pointer.
struct Form {
    // Vertices are lit in object coordinates, and the lights are brought there once per Draw. Possible if the
    // modelview matrix keeps angles; it saves transforming each vertex's position and normal.
    bool object_space = false;
    // Every sum in the order of --precise (precise.h). Then object_space follows the driver's choice.
    bool precise = false;
    // Vectors from a vertex to lights and viewer lead by way of the nearest vertex, and any length of theirs is squared safely
    // (wide_range.h).
    bool wide_range = false;
    // Vertices are lit in homogeneous eye coordinates, without a division by w, which may be 0 and differ from vertex to vertex.
    bool homogeneous = false;
    // Normals are scaled to length 1, and the matrix's columns differ so much that the square of a normal's length may leave the floats.
    bool wide_normals = false;
    // Normals are not scaled to length 1, and are so short or long that the square of their cosine with the half vector may leave the floats.
    // Then their size is taken out first, and multiplied in again where the equation needs it.
    bool sized_normals = false;
    bool rescale = false;    // precise and kept only: multiplies normals by GL_RESCALE_NORMAL's factor
    bool position_w = true;  // a position's w may differ from 1
    // Each of the last loops.size() lights of the effects represents many lights that differ only in numbers. The
    // shader goes through them in a loop, over arrays of these lengths.
    std::vector<int> loops;
    SurfaceForm surface{};
    Glsl dialect = Glsl::k130;
    Enum alpha_func = kGL_ALWAYS;  // core GL and OpenGL ES lack the alpha test
    bool sizes_points = false;     // sets glPointSize's size, which OpenGL ES lacks
    bool clips_points = false;     // a point is seen whole or not at all; browsers may draw a part
    bool sprites_rise = false;     // GL_LOWER_LEFT, which OpenGL ES lacks for point sprites
    // OpenGL ES lacks wide, stippled and smooth lines, smooth points, and GL_TEXTURE_LOD_BIAS.
    Rectangles rectangles = Rectangles::kNone;
    bool smooth = false;        // lines of rectangles, or points
    bool line_stipple = false;  // of lines of rectangles
    bool flat_edges =
        false;  // edges and corners of flat polygons: another vertex gives the colour; a_edge_position is their place
    bool polygon_stipple = false;
    bool lod_bias = false;
    // A texture may have a rim of texels with the border's colour, which OpenGL ES lacks; u_texture_inside is the part within. Of a
    // cube map's face it is the part that no other face is mixed with.
    bool texture_rims = false;
    bool scales_source =
        false;  // multiplies the colour by blending's factor for it, where WebGL refuses a pair of factors
    Enum logic_op = kGL_COPY;  // glLogicOp, which OpenGL ES lacks
    std::optional<KeptForm> kept{};

    // Whether the fragment shader needs the middle of a point.
    bool needs_point_window() const { return smooth && rectangles != Rectangles::kLines; }

    friend auto operator<=>(const Form&, const Form&) = default;  // NOLINT
};

// The inputs from which a Draw's program is made.
struct Code {
    EffectSet effects;  // the plan's, with one light for all lights of a loop
    Form form;
    std::vector<std::vector<std::size_t>> lights;  // for each light of `effects`: indices into plan.lights
    std::optional<glm::dvec3> origin_object;       // uploaded positions are relative to this (upload_origin())
};

// If the object and the camera are far from the object's origin, floats are too coarse for the vertices' distance from
// the eye. Then vertices are uploaded relative to a point among them, subtracted in double precision. Returns that
// point, in object coordinates, or nothing if vertices are uploaded unchanged. `facts` are the Draw's vertex facts.
std::optional<glm::dvec3> upload_origin(const Draw& draw, const VertexFacts& facts);

Code code_for(const Draw& draw, const Plan& plan, const SurfaceForm& surface = {});
// Whether the outcome of glLogicOp's operation depends on the picture before it.
bool reads_stored_color(Enum logic_op);
// Sets the dialect, and what the program does because the dialect lacks it: the alpha test, sizes of points, 1D textures.
void set_dialect(Code& code, const Draw& draw, Glsl dialect);
// Form::sized_normals of a Draw that is a mesh.
bool has_sized_normals(const Draw& draw, const Plan& plan);

// If more than this many lights have equal facts, the shader loops over them, so that its text stays short. On llvmpipe
// a light in the loop takes four times as long as an unrolled one, but each unrolled light takes about 4 ms to compile.
inline constexpr std::size_t kMostWrittenOut = 32;

// The factor by which the modelview matrix scales lengths, if it only rotates, mirrors, translates and scales all
// directions alike (to float precision); otherwise 0.
double similarity_scale(const glm::dmat4& eye_from_object);

}  // namespace twinlight::programmable
