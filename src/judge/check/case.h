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

#include "base/image/embedded.h"
#include "render/look.h"
#include "scene/command/command.h"
#include "scene/frame/scene.h"

namespace twinlight {

// The files of golden/hard, by name.
extern const std::vector<EmbeddedFile> kCaseFiles;

}  // namespace twinlight

namespace twinlight::check {

// Default tolerances, relative to the larger of 1 and the value. Floats: forty operations with a rounding each, and a
// power's exponent. Double and long double: the expected values in a file have about seven digits.
inline constexpr double kTolerance = 3e-5, kWrittenTolerance = 1e-6;
// Sides of the pictures, in pixels: of a case that tests pixels, and of one that tests vertices. The second is small,
// so that a point can be seen; its corner (-0.75, -0.75) is the centre of a pixel, so that all rasterisers draw the
// same one.
inline constexpr int kSide = 64, kVertexSide = 12;

// A place that a case tests: a vertex of the last Draw; a pixel, with x and y from the top left; or the result of
// glGetError after all commands.
struct Spot {
    enum class Kind : std::uint8_t { kVertex, kPixel, kError };
    Kind kind = Kind::kVertex;
    int vertex = 0;
    int x = 0, y = 0;
    std::optional<Shading> shading;  // kPhong or kExact; none: GL's own shading, which all renderers have

    std::string str() const;  // "vertex 0", "pixel 32,32 phong", "error"
    friend bool operator==(const Spot&, const Spot&) = default;
};

// The result there: a colour (of a vertex before the clamp, 2.14.6) or an error code.
using Seen = std::variant<glm::dvec4, Enum>;
std::string text_of(const std::optional<Seen>& seen);  // "(0.25, 0, 0, 1)", "GL_INVALID_VALUE", "nothing"

struct Expectation {
    Spot spot;
    Seen value;
    // A second right answer, channel by channel, where rounding decides; long double must give `value`. Equal to
    // `value` elsewhere.
    Seen other;
    glm::dvec3 secondary{0};  // of a vertex with a separate specular colour
};

// A known bug: what a driver's fixed function gives instead.
struct Differs {
    // Alternatives with '|' between them: a shell pattern that is found anywhere in driver_name(), and the releases that
    // have the bug: "llvmpipe*Mesa before 25.0|NVIDIA 580". "softpipe at times": whether it shows depends on what was drawn before.
    std::string driver;
    Spot spot;
    Seen value;        // may be NaN
    std::string name;  // in golden/known_differences

    bool is_of(const std::string& driver_name) const;
    bool is_at_times(const std::string& driver_name) const;
    // compare::measured_note() of a driver that counts as another release; empty where `driver` names the release itself.
    std::string note(const std::string& driver_name) const;
};

// The scene that a case's commands make, and the first error that they raise.
struct CarriedOut {
    Scene scene;
    Enum error = kGL_NO_ERROR;
};

struct Case {
    std::string name;
    std::string what, why, text, derived;
    bool is_ruling = false;           // the specification is silent, and the expected answer is our choice
    std::optional<double> tolerance;  // instead of kTolerance
    std::string tolerance_causes;
    std::vector<Expectation> expectations;
    std::vector<Differs> differs;
    std::string scene_text;
    std::shared_ptr<const CommandList> scene;

    bool is_of_vertices() const;
    bool expects_error() const;  // also true where the case expects GL_NO_ERROR
    // The scene at `side` by `side` pixels. Throws SceneError as make_frame does. A case that expects an error may
    // raise GL errors: their commands are ignored (2.5).
    CarriedOut carried_out(int side) const;
};

// Throws SceneError, with the line, where the head breaks the format of docs/hard-cases.md or the scene cannot be read.
Case read_case(std::string_view text, const std::string& file, const std::string& name);

// All cases of golden/hard, or those with these names; a name may also be your own case file. Throws SceneError and
// FileError.
std::vector<Case> load_cases(const std::vector<std::string>& names = {});

}  // namespace twinlight::check
