#include "render/programmable/export/scene_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "render/programmable/export/c_text.h"

namespace twinlight::programmable {
namespace {

void add_lines(std::string& text, std::string_view lines) {
    for (std::size_t at = 0; at < lines.size();) {
        const std::size_t end = std::min(lines.find('\n', at), lines.size());
        text += fmt::format("    {}\n", lines.substr(at, end - at));
        at = end + 1;
    }
}

// Without the errors of rounding that products and inverses leave in place of 0, and that would make equal lists differ. A column is a
// direction or a position, so its numbers have one size.
glm::dmat4 rounded(glm::dmat4 m) {
    constexpr int kBits = 34;  // floats have 24
    for (int column = 0; column < 4; ++column) {
        double largest = 0;
        for (int row = 0; row < 4; ++row) largest = std::max(largest, std::abs(m[column][row]));
        const double unit = std::ldexp(1.0, largest > 0 ? std::ilogb(largest) - kBits : 0);
        for (int row = 0; row < 4; ++row) m[column][row] = std::round(m[column][row] / unit) * unit + 0.0;  // not -0
    }
    return m;
}
// Whether the product, in floats, is this matrix. It is not where `base` has no inverse, as for shadows on a plane.
bool is_product(const glm::dmat4& m, const glm::dmat4& base, const glm::dmat4& relative) {
    constexpr double kTolerance = 0x1p-20;  // a thousandth of a pixel at the border of a picture of 1000
    const glm::dmat4 product = glm::dmat4(glm::mat4(base)) * glm::dmat4(glm::mat4(relative));
    for (int column = 0; column < 4; ++column) {
        double largest = 0, off = 0;
        for (int row = 0; row < 4; ++row) {
            const double difference = std::abs(product[column][row] - m[column][row]);
            if (!(difference <= std::numeric_limits<double>::max())) return false;
            largest = std::max(largest, std::abs(m[column][row]));
            off = std::max(off, difference);
        }
        if (off > kTolerance * largest) return false;
    }
    return true;
}

template <class Number>
std::string with_each(const std::vector<float>& numbers, const Number& number) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size(); ++i) text += (i == 0 ? "" : ", ") + number(i);
    return text;
}
std::string with_parts(std::string text, const std::string& each, const std::string& array) {
    for (const auto& [mark, part] : {std::pair('@', &each), {'*', &array}})
        if (const std::size_t at = text.find(mark); at != text.npos) text.replace(at, 1, *part);
    return text;
}
std::string with_numbers(const CallText& call) {
    const std::string each = with_each(call.numbers, [&](std::size_t i) { return c_number(call.numbers[i]); });
    return with_parts(call.text, each, fmt::format("(float[]){{{}}}", each));
}
// The same with numbers that differ between frames: frame_values has them from `first` on.
std::string with_numbers_at(const CallText& call, std::size_t first) {
    return with_parts(
        call.text, with_each(call.numbers, [&](std::size_t i) { return fmt::format("frame_values[{}]", first + i); }),
        first == 0 ? "frame_values" : fmt::format("frame_values + {}", first));
}

// A call for each frame.
using CallRow = std::vector<CallText>;

// glMaterial sets both colours at once.
void join_ambient_and_diffuse(std::vector<CallRow>& rows) {
    const auto in_place_of_ambient = [](std::string text, const char* name) {
        const std::size_t at = text.find("GL_AMBIENT, *");
        return text.starts_with("ffMaterial") && at != text.npos ? text.replace(at, 10, name) : "";
    };
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        CallRow joined = rows[i];
        for (CallText& call : joined) call.text = in_place_of_ambient(call.text, "GL_DIFFUSE");
        if (joined != rows[i + 1]) continue;
        for (CallText& call : rows[i]) call.text = in_place_of_ambient(call.text, "GL_AMBIENT_AND_DIFFUSE");
        rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
}

// The names of meshes and lists, and their definitions.
class SceneNames {
  public:
    explicit SceneNames(const SceneSteps& steps) : steps_(steps) {}

    // The name of a mesh, or of an array with a mesh for each frame.
    std::string mesh_name(const std::vector<std::size_t>& meshes, const SceneStep& step) {
        const bool is_one = std::ranges::all_of(meshes, [&](std::size_t mesh) { return mesh == meshes.front(); });
        std::string& name = mesh_names_[is_one ? std::vector{meshes.front()} : meshes];
        if (name.empty()) {
            name = free_name(wanted_name(step));
            const auto row = [this](std::size_t number) {
                const MeshPlace& mesh = steps_.mesh(number);
                return fmt::format("{{{}, layout{}, {}, {}, {}}}", primitive_name(mesh.mode), mesh.layout,
                                   mesh.first_vertex, mesh.first_index, mesh.index_count);
            };
            const std::string place = printable(step.place.str());
            if (is_one) {
                mesh_text_ +=
                    fmt::format("static const struct mesh {} = {};  // {}\n", name, row(meshes.front()), place);
            } else {
                mesh_text_ += fmt::format("static const struct mesh {}[] = {{  // {}\n", name, place);
                for (const std::size_t mesh : meshes) mesh_text_ += fmt::format("    {},\n", row(mesh));
                mesh_text_ += "};\n";
            }
        }
        return is_one ? name : name + "[frame_index]";
    }

    std::string list_name(std::uint32_t list, const std::string& body) {
        std::string& name = list_names_[{list, body}];
        if (name.empty()) {
            name = free_name(fmt::format("list{}", list));
            list_text_ += fmt::format("// Display list {}\nstatic void {}(void) {{\n{}}}\n\n", list, name, body);
        }
        return name;
    }

    const std::string& meshes() const { return mesh_text_; }
    const std::string& lists() const { return list_text_; }

  private:
    // "list2_mesh" for a display list's mesh, "mesh134" for line 134.
    static std::string wanted_name(const SceneStep& step) {
        if (!step.name.empty()) return step.name;
        if (!step.lists.empty()) return fmt::format("list{}_mesh", step.lists.back()->name);
        return has_line(step.place) ? fmt::format("mesh{}", step.place.line) : "mesh";
    }
    std::string free_name(const std::string& wanted) {
        const int count = ++names_[wanted];
        return count == 1 ? wanted : fmt::format("{}_{}", wanted, count);
    }

    const SceneSteps& steps_;
    std::map<std::vector<std::size_t>, std::string> mesh_names_;               // by the meshes of all frames
    std::map<std::pair<std::uint32_t, std::string>, std::string> list_names_;  // of a list with this body
    std::map<std::string, int> names_;                                         // how often each was wanted
    std::string mesh_text_, list_text_;
};

// The text of a function that draws the frames of one shape.
class FunctionText {
  public:
    FunctionText(const SceneSteps& steps, SceneNames& names, std::vector<const SceneFrame*> frames)
        : steps_(steps), names_(names), frames_(std::move(frames)), numbers_(frames_.size()) {}

    std::string text() {
        Known known;
        return body({0, frames_.front()->steps.size()}, 0, nullptr, known);
    }
    // For each frame, the numbers that not all frames share.
    const std::vector<std::vector<float>>& numbers() const { return numbers_; }

  private:
    // One for each frame.
    using Calls = std::vector<int>;
    using Matrices = std::vector<glm::dmat4>;
    using Known = std::map<int, Calls>;  // the last call of each key
    struct Range {
        std::size_t first = 0, end = 0;
    };
    // What is set before some steps, and what these change themselves.
    struct State {
        std::vector<std::pair<int, Calls>> before;
        std::set<int> inside;
    };

    const SceneStep& step(std::size_t i) const { return frames_.front()->steps[i]; }

    // The call of `depth` other lists that draws this step and those after it.
    Range list_at(std::size_t first, std::size_t end, std::size_t depth) const {
        Range range{first, first};
        while (range.end < end && step(range.end).lists.size() > depth &&
               step(range.end).lists[depth] == step(first).lists[depth])
            ++range.end;
        return range;
    }

    State state_of(Range range) const {
        State state;
        std::map<int, std::size_t> at;  // in state.before
        for (std::size_t i = range.first; i < range.end; ++i) {
            for (std::size_t j = 0; j < step(i).sets.size(); ++j) {
                const int key = step(i).sets[j].key;
                Calls calls;
                for (const SceneFrame* frame : frames_) calls.push_back(frame->steps[i].sets[j].call);
                const auto [found, is_new] = at.try_emplace(key, state.before.size());
                if (is_new)
                    state.before.emplace_back(key, std::move(calls));
                else if (state.before[found->second].second != calls)
                    state.inside.insert(key);
            }
            if (range.end - range.first > 1)
                state.inside.insert(step(i).unknown_after.begin(), step(i).unknown_after.end());
        }
        std::erase_if(state.before, [&](const auto& one) { return state.inside.contains(one.first); });
        return state;
    }

    template <class MatrixOf>
    Matrices matrices(const MatrixOf& matrix_of) const {
        Matrices result;
        for (const SceneFrame* frame : frames_) result.push_back(matrix_of(*frame));
        return result;
    }
    Matrices of_step(std::size_t i) const {
        return matrices([i](const SceneFrame& frame) { return frame.steps[i].eye_from_object; });
    }
    Matrices of_list(std::size_t i, std::size_t depth) const {
        return matrices([&](const SceneFrame& frame) { return frame.steps[i].lists[depth]->eye_from_object; });
    }
    static Matrices relative(const Matrices& base, const Matrices& to) {
        Matrices result;
        for (std::size_t i = 0; i < to.size(); ++i) result.push_back(rounded(glm::inverse(base[i]) * to[i]));
        return result;
    }
    bool is_identity(const Matrices& all) const { return all == Matrices(frames_.size(), glm::dmat4(1)); }

    // A list is a function if its state does not need the camera's matrix, and its own matrices follow from that of its call.
    bool is_function(Range range, std::size_t depth) {
        constexpr std::size_t kDeepest = 24;  // gl_state.c keeps 32 matrices
        if (range.end - range.first < 2 || depth > kDeepest) return false;
        const auto [known, is_new] = is_function_.try_emplace(step(range.first).lists[depth].get(), true);
        if (is_new) known->second = may_be_function(range, depth);
        return known->second;
    }
    bool may_be_function(Range range, std::size_t depth) const {
        for (const int key : state_of(range).inside)
            if (steps_.scope(key) == CallScope::kEye) return false;
        const Matrices base = of_list(range.first, depth);
        const auto follows = [&](const Matrices& matrices) {
            const Matrices relatives = relative(base, matrices);
            for (std::size_t i = 0; i < base.size(); ++i)
                if (!is_product(matrices[i], base[i], relatives[i])) return false;
            return true;
        };
        for (std::size_t i = range.first; i < range.end; ++i) {
            if (!follows(of_step(i))) return false;
            for (std::size_t inner = depth + 1; inner < step(i).lists.size(); ++inner)
                if (!follows(of_list(i, inner))) return false;
        }
        return true;
    }

    // One step, or those of a list that is a function.
    struct Part {
        Range steps;
        std::optional<std::size_t> list{};  // into SceneStep::lists
    };
    // The next part of a function that `depth` lists call: the outermost list that is a function.
    Part part_at(Range range, std::size_t depth) {
        for (std::size_t list = depth; list < step(range.first).lists.size(); ++list)
            if (const Range steps = list_at(range.first, range.end, list); is_function(steps, list))
                return {steps, list};
        return {{range.first, range.first + 1}};
    }
    // Where the program calls it: also a list that is only one mesh.
    const Place& place_of(const Part& part, Range range, std::size_t depth) const {
        const SceneStep& first = step(part.steps.first);
        if (part.list) return first.lists[*part.list]->place;
        const bool is_list =
            first.lists.size() > depth && list_at(part.steps.first, range.end, depth).end == part.steps.end;
        return is_list ? first.lists[depth]->place : first.place;
    }

    // The modelview matrices: in a frame, or after the matrices of the call of a list.
    struct ModelView {
        const Matrices* base = nullptr;  // null in a frame
        std::optional<Matrices> current{};
        bool is_pushed = false;
    };
    Matrices wanted(const ModelView& view, const Matrices& next) const {
        return view.base ? relative(*view.base, next) : next;
    }
    void pop_before(ModelView& view, const Matrices& next, std::string& text) const {
        if (!view.is_pushed || wanted(view, next) == view.current) return;
        add_lines(text, "ffPopMatrix();");
        view.current = Matrices(frames_.size(), glm::dmat4(1));
        view.is_pushed = false;
    }
    void set(ModelView& view, const Matrices& next, const std::string& in_eye, std::string& text) {
        const Matrices matrices = wanted(view, next);
        if (in_eye.empty() && view.current == matrices) return;
        view.current = matrices;
        view.is_pushed = view.base != nullptr;
        add_lines(text, view.base ? "ffPushMatrix();" : "camera();");
        text += in_eye;
        if (!is_identity(matrices)) add_lines(text, matrix_text(matrices));
    }

    // The steps as statements. `base`: in a list's function, the matrices of its call; otherwise null. `known` is what is set before and,
    // after that, at the end.
    std::string body(Range range, std::size_t depth, const Matrices* base, Known& known) {
        std::string text;
        Place place;
        ModelView view{.base = base};
        if (base) view.current = Matrices(frames_.size(), glm::dmat4(1));
        while (range.first < range.end) {
            const Part part = part_at(range, depth);
            const SceneStep& first = step(range.first);
            const Matrices at = part.list ? of_list(range.first, *part.list) : of_step(range.first);
            const State state = state_of(part.steps);
            if (first.clear.empty()) {
                pop_before(view, at, text);
                const Place& next = place_of(part, range, depth);
                if (next != place)
                    text += fmt::format("{}    // {}\n", text.empty() ? "" : "\n", printable(next.str()));
                place = next;
            }
            const auto [anywhere, in_eye] = set_changed(state, known);
            text += anywhere;
            if (first.clear.empty()) set(view, at, in_eye, text);
            if (part.list) {
                for (const int key : state.inside) known.erase(key);
                const std::string inside = body(part.steps, *part.list + 1, &at, known);
                add_lines(text, names_.list_name(first.lists[*part.list]->name, inside) + "();");
            } else {
                add_lines(text, first.clear.empty() ? draw_text(range.first) : first.clear);
            }
            for (std::size_t i = part.steps.first; i < part.steps.end; ++i)
                for (const int key : step(i).unknown_after) known.erase(key);
            range.first = part.steps.end;
        }
        if (view.is_pushed) add_lines(text, "ffPopMatrix();");
        return text;
    }

    std::string draw_text(std::size_t i) {
        std::vector<std::size_t> meshes;
        for (const SceneFrame* frame : frames_) meshes.push_back(frame->steps[i].mesh);
        return fmt::format("draw({});", names_.mesh_name(meshes, step(i)));
    }

    // The calls for what changes: those that may be anywhere, and those that need the camera's matrix.
    std::pair<std::string, std::string> set_changed(const State& state, Known& known) {
        std::vector<CallRow> anywhere, in_eye;
        for (const auto& [key, calls] : state.before) {
            Calls& last = known[key];
            if (last == calls) continue;
            last = calls;
            const bool needs_eye = steps_.scope(key) == CallScope::kEye;
            CallRow& row = (needs_eye ? in_eye : anywhere).emplace_back();
            for (const int call : calls) row.push_back(steps_.call(call));
        }
        join_ambient_and_diffuse(anywhere);
        std::pair<std::string, std::string> text;
        for (const CallRow& row : anywhere) add_lines(text.first, call_text(row));
        for (const CallRow& row : in_eye) add_lines(text.second, call_text(row));
        return text;
    }

    std::string matrix_text(const Matrices& all) {
        CallRow row;
        for (const glm::dmat4& matrix : all) row.push_back(matrix_call(rounded(matrix)));
        return call_text(row);
    }
    // With numbers of its own for each frame, unless all frames have the same.
    std::string call_text(const CallRow& of_frames) {
        const CallText& first = of_frames.front();
        if (std::ranges::all_of(of_frames, [&](const CallText& one) { return one == first; }))
            return with_numbers(first);
        const std::size_t at = numbers_.front().size();
        for (std::size_t i = 0; i < of_frames.size(); ++i)
            numbers_[i].insert(numbers_[i].end(), of_frames[i].numbers.begin(), of_frames[i].numbers.end());
        return with_numbers_at(first, at);
    }

    const SceneSteps& steps_;
    SceneNames& names_;
    std::vector<const SceneFrame*> frames_;
    std::vector<std::vector<float>> numbers_;
    std::map<const ListCall*, bool> is_function_;
};

}  // namespace

SceneParts scene_parts(const SceneSteps& steps, ExportWords& data) {
    SceneParts parts;
    std::vector<CallRow> constants;
    for (const CallText& call : steps.constants()) constants.push_back({call});
    join_ambient_and_diffuse(constants);
    for (const CallRow& row : constants) add_lines(parts.load, with_numbers(row.front()));
    std::map<std::size_t, std::vector<const SceneFrame*>> functions;
    for (const SceneFrame& frame : steps.frames()) functions[frame.function].push_back(&frame);
    SceneNames names(steps);
    std::map<const SceneFrame*, std::string> rows;
    for (const auto& [number, frames] : functions) {
        FunctionText function(steps, names, frames);
        const std::string name =
            functions.size() == 1 ? "draw_scene" : fmt::format("draw_frame{}", frames.front()->number);
        parts.frames +=
            fmt::format("{}static void {}(void) {{\n{}}}\n", parts.frames.empty() ? "" : "\n", name, function.text());
        for (const SceneFrame* frame : frames)
            rows[frame] = fmt::format("    {{{}, {}, {}, {}}},\n", frame->number, name, frame->index,
                                      data.place_of(function.numbers()[frame->index]).first);
    }
    for (const SceneFrame& frame : steps.frames()) parts.table += rows[&frame];
    for (std::size_t i = 0; i < steps.layouts().size(); ++i)
        parts.layouts += fmt::format("static const struct attribute layout{}[] = {{{}{{NULL, 0, 0}}}};\n", i + 1,
                                     steps.layouts()[i]);
    parts.meshes = names.meshes();
    parts.lists = names.lists();
    return parts;
}

}  // namespace twinlight::programmable
