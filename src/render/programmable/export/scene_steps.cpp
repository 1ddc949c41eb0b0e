#include "render/programmable/export/scene_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace twinlight::programmable {
namespace {

std::vector<std::shared_ptr<const ListCall>> lists_of(const Draw& draw) {
    std::vector<std::shared_ptr<const ListCall>> lists;
    for (std::shared_ptr<const ListCall> list = draw.list; list; list = list->outer) lists.push_back(list);
    std::ranges::reverse(lists);
    return lists;
}

}  // namespace

bool has_line(const Place& place) { return place.column != Place::kCallNumber && place.line > 0; }

// ---- Steps ----

SceneSteps::SceneSteps(ExportWords& data) : data_(data) {
    for (const Setting& setting : initial_settings()) initial_[key_of(setting)] = call_of(setting.call);
}

int SceneSteps::key_of(const Setting& setting) {
    const auto [at, is_new] = keys_.try_emplace(setting.key, static_cast<int>(keys_.size()));
    if (is_new) scopes_.push_back(setting.scope);
    return at->second;
}
int SceneSteps::call_of(const CallText& call) {
    const auto [at, is_new] = call_numbers_.try_emplace(call, static_cast<int>(calls_.size()));
    if (is_new) calls_.push_back(call);
    return at->second;
}
std::vector<SceneStep::Set> SceneSteps::sets_of(const std::vector<Setting>& settings) {
    std::vector<SceneStep::Set> sets;
    for (const Setting& setting : settings) sets.push_back({key_of(setting), call_of(setting.call)});
    return sets;
}

void SceneSteps::begin_frame(int number) {
    end_mesh();
    frames_.push_back({.number = number});
}

void SceneSteps::clear(const Clear& clear) {
    if (!clear.color && !clear.depth && !clear.stencil) return;
    end_mesh();
    SceneStep step;
    step.sets = sets_of(settings_of(clear));
    step.clear = programmable::call_of(clear);
    frames_.back().steps.push_back(std::move(step));
}

bool SceneSteps::continues(const SceneStep& last, const SceneStep& next, const SceneMesh& mesh) const {
    const bool is_one_place = last.place == next.place || (!has_line(last.place) && !has_line(next.place));
    return last.clear.empty() && is_one_place && last.lists == next.lists && last.kind == next.kind &&
           last.eye_from_object == next.eye_from_object && last.sets == next.sets && open_.mode == mesh.mode &&
           open_.layout == mesh.layout;
}

void SceneSteps::draw(const Draw& draw, const std::vector<Setting>& settings,
                      const std::vector<std::string>& unknown_after, int kind, SceneMesh mesh,
                      const std::string& name) {
    SceneStep step;
    step.sets = sets_of(settings);
    for (const std::string& key : unknown_after) step.unknown_after.push_back(key_of({key, {}, {}}));
    step.kind = kind;
    step.name = name;
    step.eye_from_object = draw.eye_from_object;
    step.place = draw.place;
    step.lists = lists_of(draw);
    std::vector<SceneStep>& steps = frames_.back().steps;
    if (open_.vertex_count > 0 && continues(steps.back(), step, mesh)) {
        for (const std::uint32_t index : mesh.indices)
            open_.indices.push_back(index + static_cast<std::uint32_t>(open_.vertex_count));
        open_.vertices.insert(open_.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        open_.vertex_count += mesh.vertex_count;
        return;
    }
    end_mesh();
    open_ = std::move(mesh);
    steps.push_back(std::move(step));
}

void SceneSteps::end_mesh() {
    if (open_.vertex_count == 0) return;
    auto layout = std::ranges::find(layouts_, open_.layout);
    if (layout == layouts_.end()) layout = layouts_.insert(layout, open_.layout);
    const std::size_t first_vertex = data_.place_of(open_.vertices).first;
    const auto [first_index, index_count] = data_.place_of(open_.indices);
    const MeshPlace mesh{open_.mode, static_cast<std::size_t>(layout - layouts_.begin()) + 1, first_vertex, first_index,
                         index_count};
    const auto [at, is_new] = mesh_numbers_.try_emplace(mesh, meshes_.size());
    if (is_new) meshes_.push_back(mesh);
    frames_.back().steps.back().mesh = at->second;
    open_ = {};
}

// ---- What frames share ----

void SceneSteps::set_kinds(const std::vector<bool>& is_by_number) {
    if (std::ranges::find(is_by_number, true) == is_by_number.end()) return;
    for (SceneFrame& frame : frames_)
        for (SceneStep& step : frame.steps) {
            if (!step.clear.empty()) continue;
            const bool by_number = is_by_number[static_cast<std::size_t>(step.kind) - 1];
            const Setting setting{"kind", {}, {fmt::format("ffUseKind({});", by_number ? step.kind : 0)}};
            step.sets.push_back({key_of(setting), call_of(setting.call)});
        }
}

void SceneSteps::take_constants() {
    std::vector<int> order;
    std::map<int, std::set<int>> calls;  // of each key
    std::set<int> unknown;
    for (const SceneFrame& frame : frames_)
        for (const SceneStep& step : frame.steps) {
            for (const SceneStep::Set& one : step.sets)
                if (calls[one.key].insert(one.call).second && calls[one.key].size() == 1) order.push_back(one.key);
            unknown.insert(step.unknown_after.begin(), step.unknown_after.end());
        }
    std::set<int> constants;
    for (const int key : order) {
        if (calls[key].size() > 1 || unknown.contains(key)) continue;
        const int call = *calls[key].begin();
        const auto initial = initial_.find(key);
        const bool is_initial = initial != initial_.end() && initial->second == call;
        if (!is_initial && scopes_[static_cast<std::size_t>(key)] != CallScope::kAnywhere) continue;
        constants.insert(key);
        if (!is_initial) constants_.push_back(calls_[static_cast<std::size_t>(call)]);
    }
    for (SceneFrame& frame : frames_)
        for (SceneStep& step : frame.steps)
            std::erase_if(step.sets, [&](const SceneStep::Set& one) { return constants.contains(one.key); });
}

// Frames of one shape have the same steps, but for numbers and for which vertices a mesh has.
std::vector<int> SceneSteps::shape_of(const SceneFrame& frame) {
    std::vector<int> shape;
    const auto number_of = [this](const std::string& text) { return call_of({text}); };
    const SceneStep* last = nullptr;
    for (const SceneStep& step : frame.steps) {
        shape.push_back(number_of(step.clear));
        for (const SceneStep::Set& one : step.sets) {
            shape.push_back(one.key);
            shape.push_back(number_of(calls_[static_cast<std::size_t>(one.call)].text));
        }
        shape.insert(shape.end(), {-1, step.kind});
        if (step.clear.empty()) {
            const MeshPlace& mesh = meshes_[step.mesh];
            shape.insert(shape.end(), {static_cast<int>(mesh.mode), static_cast<int>(mesh.layout), number_of(step.name),
                                       number_of(has_line(step.place) ? step.place.str() : "")});
        }
        for (std::size_t i = 0; i < step.lists.size(); ++i)
            shape.insert(shape.end(), {static_cast<int>(step.lists[i]->name),
                                       last && i < last->lists.size() && last->lists[i] == step.lists[i] ? 1 : 0});
        shape.push_back(-2);
        last = &step;
    }
    return shape;
}

void SceneSteps::finish(const std::vector<bool>& is_by_number) {
    end_mesh();
    set_kinds(is_by_number);
    take_constants();
    std::map<std::vector<int>, std::pair<std::size_t, std::size_t>> found;  // the function, and how many frames have it
    for (SceneFrame& frame : frames_) {
        auto& [function, count] = found.try_emplace(shape_of(frame), found.size(), 0).first->second;
        frame.function = function;
        frame.index = count++;
    }
}

}  // namespace twinlight::programmable
