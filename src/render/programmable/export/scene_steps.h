// The steps of frames, for scene.c: clears and draws of meshes, each with the state that it needs. Equal state, meshes and numbers
// are equal numbers here, in all frames.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "render/programmable/export/export_words.h"
#include "render/programmable/export/state_calls.h"
#include "scene/frame/frame.h"

namespace twinlight::programmable {

// Points, lines or triangles, one by one, so that meshes with one state are joined.
struct SceneMesh {
    Enum mode = 0;
    std::string layout;           // the members of its array of struct attribute
    std::vector<float> vertices;  // `vertex_count` of them
    std::size_t vertex_count = 0;
    std::vector<std::uint32_t> indices;
};
// The same in scene.bin.
struct MeshPlace {
    Enum mode = 0;
    std::size_t layout = 0, first_vertex = 0, first_index = 0, index_count = 0;  // the layout counts from 1

    friend auto operator<=>(const MeshPlace&, const MeshPlace&) = default;  // NOLINT
};

struct SceneStep {
    struct Set {
        int key = 0, call = 0;

        friend auto operator<=>(const Set&, const Set&) = default;  // NOLINT
    };
    std::vector<Set> sets;
    std::vector<int> unknown_after;  // keys
    std::string clear;               // "glClear(...);"; empty: a draw
    int kind = 0;
    std::size_t mesh = 0;
    std::string name;  // of the shape or function that makes the mesh; empty if it is not known
    glm::dmat4 eye_from_object{1};
    Place place;
    std::vector<std::shared_ptr<const ListCall>> lists;  // that draw it, the outermost first
};

struct SceneFrame {
    int number = 0;  // in the recording
    std::vector<SceneStep> steps{};
    std::size_t function = 0;  // frames with the same function have the same steps, but for numbers and meshes
    std::size_t index = 0;     // among these
};

// Whether the place is a line of a source, and not a call of a recording.
bool has_line(const Place& place);

class SceneSteps {
  public:
    explicit SceneSteps(ExportWords& data);

    // In order: the items of a frame.
    void begin_frame(int number);
    void clear(const Clear& clear);
    void draw(const Draw& draw, const std::vector<Setting>& settings, const std::vector<std::string>& unknown_after,
              int kind, SceneMesh mesh, const std::string& name);
    // After the last. Takes what never changes out of the steps, and finds the frames that differ only in numbers and meshes.
    // `is_by_number`: for each kind whether a Draw needs ffUseKind() for it.
    void finish(const std::vector<bool>& is_by_number);

    const std::vector<SceneFrame>& frames() const { return frames_; }
    const std::vector<CallText>& constants() const { return constants_; }  // what never changes and is not initial
    const CallText& call(int number) const { return calls_[static_cast<std::size_t>(number)]; }
    CallScope scope(int key) const { return scopes_[static_cast<std::size_t>(key)]; }
    const MeshPlace& mesh(std::size_t number) const { return meshes_[number]; }
    const std::vector<std::string>& layouts() const { return layouts_; }

  private:
    int key_of(const Setting& setting);
    int call_of(const CallText& call);
    std::vector<SceneStep::Set> sets_of(const std::vector<Setting>& settings);
    bool continues(const SceneStep& last, const SceneStep& next, const SceneMesh& mesh) const;
    void end_mesh();
    void set_kinds(const std::vector<bool>& is_by_number);
    void take_constants();
    std::vector<int> shape_of(const SceneFrame& frame);

    ExportWords& data_;
    std::map<std::string, int> keys_;
    std::vector<CallScope> scopes_;  // of keys
    std::map<CallText, int> call_numbers_;
    std::vector<CallText> calls_;
    std::map<int, int> initial_;  // key: call
    std::vector<CallText> constants_;
    std::vector<SceneFrame> frames_;
    SceneMesh open_;  // of the last step, which the next Draw may continue
    std::vector<std::string> layouts_;
    std::map<MeshPlace, std::size_t> mesh_numbers_;
    std::vector<MeshPlace> meshes_;
};

}  // namespace twinlight::programmable
