// What the real libraries send for a shape (tests/window/recorder), beside what src/scene/shape says that they send.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/shape/shape.h"

namespace twinlight {

struct SentVertex {
    glm::dvec3 position_object{0};
    std::optional<glm::dvec3> normal_object;  // nothing: the shape has not sent one yet
    std::optional<glm::dvec2> tex_coord;
};

struct SentPart {
    Enum mode = 0;
    bool immediate = false;
    std::vector<SentVertex> vertices;
};

struct RecordedCall {
    std::string call;
    std::vector<SentPart> parts;
    std::optional<Enum> error;  // that GLU reported
};

// Runs the recorder; `display` ":1" for glut's shapes, which need one.
std::vector<RecordedCall> record(const std::vector<std::string>& calls, const std::string& display = "");

// Our parts in the same form.
std::vector<SentPart> sent_parts(const std::vector<ShapePart>& parts);

// How far what the library sends may lie from ours, in one vertex.
struct Tolerance {
    double position = 0;
    double normal = 0;
    double tex_coord = 0;
};

// Expects the same parts: modes, counts, what is sent and what is not, values within tolerance(part, vertex). A normal that is
// NaN is ours where it is 0. Returns the largest share of its tolerance that a value has used.
double expect_same(const std::vector<SentPart>& ours, const std::vector<SentPart>& theirs,
                   const std::function<Tolerance(std::size_t part, std::size_t vertex)>& tolerance);

}  // namespace twinlight
