#include "scene/scenes/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/image/file.h"
#include "base/text/translation.h"
#include "scene/command/cpp_words.h"
#include "scene/command/lexer.h"
#include "scene/command/text.h"
#include "scene/scenes/beside.h"
#include "scene/scenes/images.h"
#include "scene/scenes/meshes.h"
#include "scene/trace/trace.h"

namespace twinlight {

namespace {

// One byte more than the limit, to detect texts that are too long.
constexpr std::size_t kReadAtMost = kMaxSceneBytes + 1;

CommandList read_limited(const std::string& text, const std::string& file, const std::string& name,
                         const ReadOptions& options, const ImageLoader& load_image = no_images) {
    if (text.size() > kMaxSceneBytes) {
        throw SceneError(tr("{}: is larger than {} MiB, the limit for a scene", file, kMaxSceneBytes >> 20));
    }
    return read_scene(text, file, name, load_image, options);
}

std::string how_to_record(const std::string& scene) {
    const std::string trace = std::filesystem::path(scene).stem().string() + ".trace";
    return tr("to run it and record what it draws: twinlight record {} -o {}", scene, trace);
}

bool is_c_program(std::string_view text) {
    return text.find("main(") != std::string_view::npos || text.find("main (") != std::string_view::npos;
}

// A program of GLFW or SDL.
bool is_program_without_loop(std::string_view text) {
    const auto has = [&](std::string_view words) { return text.find(words) != text.npos; };
    return !has("glutMainLoop") && has("#include") && (has("int main") || has("void main") || has("\nmain"));
}

// The text of a file that a program beside it includes; nullopt if there is none, or if it is a copy of a library's header.
std::optional<std::string> included_text(const std::filesystem::path& program, const std::string& name) {
    constexpr std::string_view kOfLibraries[] = {"gl.h",   "glu.h",          "glut.h",         "freeglut.h", "glext.h",
                                                 "glew.h", "freeglut_std.h", "freeglut_ext.h", "glad.h"};
    if (std::ranges::find(kOfLibraries, name) != std::end(kOfLibraries)) return std::nullopt;
    try {
        return read_file(file_beside(program.parent_path(), name, "header", "shapes.h").string(), kReadAtMost);
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

void check_no_step(const std::string& scene, const std::string& step) {
    if (!step.empty())
        throw SceneError(
            tr("{}: a recorded program has no steps; leave out --step (--frame chooses a frame)", one_line(scene)));
}

// Standard input has no folder, so it can use only the files of the built-in scenes.
CommandList read_from_nowhere(const std::string& text, ReadOptions options, const std::string& file = "<stdin>",
                              const std::string& name = "stdin") {
    options.load_mesh = meshes_built_in;
    return read_limited(text, file, name, options, images_built_in);
}

// With the files beside it. Both names are printed and written into pages, so control characters are escaped.
CommandList read_in_its_folder(const std::filesystem::path& path, const std::string& text, ReadOptions options) {
    options.load_mesh = meshes_beside(path);
    options.load_text = [&path](const std::string& file) { return included_text(path, file); };
    return read_limited(text, one_line(path.string()), one_line(path.filename().string()), options,
                        images_beside(path));
}

std::shared_ptr<const Recording> load_standard_input(const ReadOptions& options, std::optional<int> context) {
    const std::string front = read_standard_input(trace::kFrontBytes);
    if (trace::is_trace(front) || trace::is_dump(front)) {
        check_no_step("<stdin>", options.step);
        return trace::open_standard_input(front, context);
    }
    return std::make_shared<CommandList>(
        read_from_nowhere(front + read_standard_input(kReadAtMost - front.size()), options));
}

}  // namespace

CommandList read_built_in(const EmbeddedFile& file, const ReadOptions& options) {
    const std::string name(file.name);
    ReadOptions with_meshes = options;
    with_meshes.load_mesh = meshes_built_in;
    return read_scene(file.text, name, built_in_name(file), images_built_in, with_meshes);
}

const EmbeddedFile* find_built_in(std::string_view name) {
    const auto file =
        std::ranges::find_if(kSceneFiles, [&](const EmbeddedFile& one) { return built_in_name(one) == name; });
    return file == kSceneFiles.end() ? nullptr : &*file;
}

std::shared_ptr<const Recording> load_recording(const std::string& scene, std::optional<WindowSize> window,
                                                const std::string& step, std::optional<int> context,
                                                std::function<bool(Enum mode, std::size_t vertices)> fits) {
    const ReadOptions options{.step = step, .window = window, .fits = std::move(fits)};
    if (scene == "-") return load_standard_input(options, context);
    if (const EmbeddedFile* file = find_built_in(scene))
        return std::make_shared<CommandList>(read_built_in(*file, options));
    const std::filesystem::path path = scene;
    // A plain word that is not a file was meant as the name of a built-in scene.
    std::error_code ignored;
    if (!path.has_parent_path() && !path.has_extension() && !std::filesystem::exists(path, ignored)) {
        std::vector<std::string> names;
        for (const EmbeddedFile& file : kSceneFiles) names.push_back(built_in_name(file));
        const auto near = nearest(scene, {names.begin(), names.end()});
        throw SceneError(
            tr("{}: there is no built-in scene and no file with this name{}", scene,
               near ? did_you_mean("'" + std::string(*near) + "'") : tr("; 'twinlight scenes' lists the scenes")));
    }
    // A pipe can be read only once.
    const bool again = std::filesystem::is_regular_file(path, ignored);
    const std::string front = read_file(scene, again ? trace::kFrontBytes : kReadAtMost);
    if (trace::is_trace(front, path) || trace::is_dump(front)) {
        check_no_step(scene, step);
        if (!again)
            throw SceneError(
                tr("{}: cannot read a recorded program from a pipe or a device; give a file, or - for standard input",
                   scene));
        return trace::is_trace(front, path) ? trace::open_trace(scene, context) : trace::open_dump(scene, context);
    }
    if (front.starts_with("\x7f"
                          "ELF"))
        throw SceneError(tr("{}: this is a program, not a scene; {}", scene, how_to_record(scene)));
    const std::string text = again ? read_file(scene, kReadAtMost) : front;
    try {
        if (!again)
            return std::make_shared<CommandList>(
                read_limited(text, one_line(scene), one_line(path.filename().string()), options));
        return std::make_shared<CommandList>(read_in_its_folder(path, text, options));
    } catch (SceneError& error) {
        const bool names_record = std::string_view(error.what()).find("twinlight record") != std::string_view::npos;
        if (is_c_program(text) && !names_record) {
            const bool is_cpp = has_cpp_name(scene) || first_cpp_word(text, scene);
            const std::string language = is_cpp ? "C++" : "C";
            // The first error would be about a line that only scenes cannot have, such as #define.
            if (is_program_without_loop(text))
                throw SceneError(
                    tr("{}: this {} program does not call glutMainLoop, so it cannot be read; {}; or run and "
                       "lint it: twinlight "
                       "lint --run {}",
                       one_line(scene), language, how_to_record(scene), one_line(scene)));
            error.note = tr("this is a {} program; {}", language, how_to_record(scene));
        }
        throw;
    }
}

std::shared_ptr<const CommandList> load_commands(const std::string& scene, const std::string& step) {
    const std::shared_ptr<const Recording> recording = load_recording(scene, std::nullopt, step);
    if (!recording->command_list()) {
        throw SceneError(
            tr("{}: a recorded program cannot be used here; use 'twinlight render', 'compare' or 'export'", scene));
    }
    return {recording, recording->command_list()};
}

CommandList read_text_of(const std::string& file, const std::string& name, const std::string& text,
                         const std::string& step) {
    return file.empty() ? read_from_nowhere(text, {.step = step}, name, name)
                        : read_in_its_folder(file, text, {.step = step});
}

std::shared_ptr<const CommandList> load_step(const std::string& scene, const CommandList& loaded,
                                             const std::string& step) {
    if (scene != "-") return load_commands(scene, step);
    return std::make_shared<CommandList>(read_from_nowhere(*loaded.text, {.step = step}));
}

}  // namespace twinlight
