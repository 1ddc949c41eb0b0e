#include "scene/scenes/scene_groups.h"

#include <iterator>

namespace twinlight {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kOfLecture[] = {"terms"sv,    "cosine"sv,        "half-vector"sv,    "several-lights"sv,
                                           "spectral"sv, "distant-light"sv, "distant-viewer"sv, "interpolation"sv,
                                           "normals"sv,  "mesh-normals"sv};
constexpr std::string_view kOfOpenGl[] = {"light-model"sv,    "attenuation"sv,    "spotlight"sv,      "shininess"sv,
                                          "materials"sv,      "material-color"sv, "color-material"sv, "no-specular"sv,
                                          "material-forms"sv, "queries"sv};
constexpr std::string_view kOfReports[] = {"report"sv, "cylinders"sv, "lab"sv, "tutorial"sv};
constexpr std::string_view kBeyond[] = {"bezier"sv,     "buffers"sv, "environment"sv,   "fog-coordinates"sv,
                                        "fragments"sv,  "labels"sv,  "monitor"sv,       "points"sv,
                                        "shadow-map"sv, "tex-gen"sv, "solid-texture"sv, "texture-units"sv};
constexpr std::string_view kForTests[] = {"commands"sv, "legacy"sv};
constexpr SceneGroup kSceneGroups[] = {{"Lecture 3: local shading models", kOfLecture},
                                       {"OpenGL's lights and materials", kOfOpenGl},
                                       {"The report, the lab and the tutorial", kOfReports},
                                       {"Beyond lighting", kBeyond},
                                       {"For tests", kForTests}};

}  // namespace

std::span<const SceneGroup> scene_groups() { return kSceneGroups; }

}  // namespace twinlight
