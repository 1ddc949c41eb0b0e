// A hard case: a scene whose head comment says what is hard about it and which colours are right (docs/hard-cases.md).
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/image/file.h"
#include "render/look.h"
#include "scene/command/command.h"
#include "scene/state/scene.h"

namespace twinlight {

// The files of golden/hard, by name.
extern const std::vector<EmbeddedFile> kCaseFiles;

}  // namespace twinlight

namespace twinlight::check {

// How far a right answer may be off where a case says nothing else, relative to the larger of 1 and the value. Of floats: forty
// operations of a last place each, and a power's exponent; of double and more: what seven digits in a file leave.
inline constexpr double kTolerance = 3e-5, kWrittenTolerance = 1e-6;
// Of a case's picture; of one about vertices, so that a point can be seen: the corner (-0.75, -0.75) is the centre of a pixel,
// which all rasterisers take for the same one.
inline constexpr int kSide = 64, kVertexSide = 12;

// Where something is seen: a vertex of the last Draw; a pixel of the picture, x and y from its top left; or what glGetError
// tells when all commands are sent.
struct Spot {
    enum class Kind : std::uint8_t { kVertex, kPixel, kError };
    Kind kind = Kind::kVertex;
    int vertex = 0;
    int x = 0, y = 0;
    std::optional<Shading> shading;  // kPhong or kExact; nothing: GL's own, which all renderers have

    std::string str() const;  // "vertex 0", "pixel 32,32 phong", "error"
    friend bool operator==(const Spot&, const Spot&) = default;
};

// What is seen there: a colour, of a vertex before the clamp (2.14.6); or an error's code.
using Seen = std::variant<glm::dvec4, Enum>;
std::string text_of(const std::optional<Seen>& seen);  // "(0.25, 0, 0, 1)", "GL_INVALID_VALUE", "nothing"

struct Expectation {
    Spot spot;
    Seen value;
    // What may be given as well, channel by channel, where rounding decides on a jump; by the reference in long double not.
    Seen other;
    glm::dvec3 secondary{0};  // of a vertex, where the specular colour is separate
};

// What a driver's fixed function is known to give instead.
struct Differs {
    std::string driver;  // "Mesa 22.3|Mesa 25.0": shell patterns; any of them, anywhere in driver_name()
    Spot spot;
    Seen value;        // may be NaN
    std::string name;  // in golden/known_differences

    bool is_of(const std::string& driver_name) const;
};

// What a case's commands come to, and the first error that they raise.
struct CarriedOut {
    Scene scene;
    Enum error = kGL_NO_ERROR;
};

struct Case {
    std::string name;
    std::string what, why, text, derived;
    bool is_ruling = false;           // the specification leaves the answer open, and the text is Twinlight's ruling
    std::optional<double> tolerance;  // in the place of kTolerance
    std::string tolerance_causes;
    std::vector<Expectation> expectations;
    std::vector<Differs> differs;
    std::string scene_text;
    std::shared_ptr<const CommandList> scene;

    bool is_of_vertices() const;
    bool expects_error() const;  // or, by name, that there is none
    // A picture of `side` by `side` pixels. Throws SceneError as make_frame does, but of a case that expects an error not for
    // those that GL raises: a command with one is ignored (2.5).
    CarriedOut carried_out(int side) const;
};

// Throws SceneError, with the line, for a head that is not of the form of docs/hard-cases.md, or a scene that is none.
Case read_case(std::string_view text, const std::string& file, const std::string& name);

// All of golden/hard; or those of these names, and of files of one's own. Throws SceneError and FileError.
std::vector<Case> load_cases(const std::vector<std::string>& names = {});

}  // namespace twinlight::check
