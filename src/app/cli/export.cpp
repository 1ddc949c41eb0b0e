// twinlight export: prints a scene as a C program, as GLSL, as a page, or as a scene file, or writes shaders to keep.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/command_line.h"
#include "app/cli/progress.h"
#include "base/image/file.h"
#include "base/image/named_file.h"
#include "render/programmable/export/kept_code.h"
#include "render/programmable/export/kept_files.h"
#include "render/programmable/export/shader_text.h"
#include "render/reference/copied_pixels.h"
#include "render/webgl/exported_page.h"
#include "render/webgpu/ported_files.h"
#include "scene/command/text.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/caption.h"
#include "scene/shape/written_out.h"

namespace twinlight::cli {

namespace {

struct ExportArguments {
    std::string scene;
    std::string form;
    std::optional<Shading> shading;
    RecordedPart part;
    std::string step;
    MemoryBudget memory{.has_size = false};
    bool precise = false;
    std::string output;  // a folder for shaders to keep, a file for a page; empty: standard output
    std::string glsl;    // the version of shaders to keep; empty: 330
    bool for_this_picture = false;
    std::optional<std::pair<int, int>> frames;  // the first and the last
};

// "12" or "0-60".
std::optional<std::pair<int, int>> read_frames(const std::string& text) {
    const auto number = [](std::string_view digits) {
        int value = -1;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        return error == std::errc() && end == digits.data() + digits.size() ? value : -1;
    };
    const std::size_t dash = text.find('-', 1);
    const int first = number(std::string_view(text).substr(0, dash));
    const int last = dash == text.npos ? first : number(std::string_view(text).substr(dash + 1));
    if (first < 0 || last < first) return std::nullopt;
    return std::pair(first, last);
}

// The scene with texels in place of copies of its picture, as the reference draws them, unless glCopyPixels draws some.
Scene with_texels(Scene scene, const programmable::Options& options) {
    const auto copies = [](const Draw* draw) { return draw->pixels && draw->pixels->copied; };
    if (scene.frame.copies_pixels && std::ranges::none_of(scene.frame.draws(), copies)) {
        Frame whole = *reference::drawable(scene.frame, {options});
        scene.frame = std::move(whole);
    }
    return scene;
}

// All steps of the scene.
std::string page_of(const std::vector<Scene>& scenes, const programmable::Options& options) {
    std::vector<webgl::PageStep> steps;
    for (const Scene& scene : scenes) {
        const CommandList* list = scene.recording->command_list();
        steps.push_back({&scene.frame, list && list->step > 0 ? list->steps[list->step - 1] : ""});
    }
    const Scene& first = scenes.front();
    const CommandList* list = first.recording->command_list();
    const Caption caption = list ? caption_of(*list) : Caption{};
    const webgl::PageText text{scenes.size() > 1 ? first.name() : first.title(), caption.title, caption.notice};
    return webgl::exported_page(steps, options, text);
}

// A recording's arrays may be larger as text than a scene file may be.
std::string scene_file_of(const Scene& scene) {
    constexpr double kMiB = 1 << 20;
    std::string text = print_scene(commands_to_print(scene));
    if (text.size() > kMaxSceneBytes)
        throw SceneError(fmt::format(
            "{}: as a scene file this frame has {:.0f} MiB, and no command reads more than {:.0f}; give the "
            "recording itself to the other commands, or use --as html or glsl",
            scene.name(), static_cast<double>(text.size()) / kMiB, kMaxSceneBytes / kMiB));
    return text;
}

using Export = std::function<std::string(const Scene&, const programmable::Options&)>;
const std::map<std::string, Export> kForms = {
    {"c", [](const Scene& scene,
             const auto&) { return print_c_program(with_pragmas_written_out(commands_to_print(scene))); }},
    {"glsl", [](const Scene& scene, const auto& options) { return programmable::shader_source(scene.frame, options); }},
    {"html", nullptr},  // page_of() has all steps
    {"scene", [](const Scene& scene, const auto&) { return scene_file_of(scene); }},
    {"vulkan", nullptr},  // these two are files: write_ported()
    {"wgsl", nullptr},
};
const std::map<std::string, webgpu::Target> kTargets = {{"vulkan", webgpu::Target::kVulkan},
                                                        {"wgsl", webgpu::Target::kWgsl}};

const std::map<std::string, programmable::Glsl> kVersions = {
    {"130", programmable::Glsl::k130}, {"330", programmable::Glsl::k330}, {"300es", programmable::Glsl::k300es}};

void check_can_be_kept(const Scene& scene, const programmable::Options& options, bool as_page) {
    constexpr const char* kRemedy = "use --as glsl --for-this-picture";
    if (options.shading == Shading::kExact)
        throw UsageError(fmt::format("--shading exact finds surfaces by rays for one picture; {}", kRemedy));
    if (options.precise) throw UsageError(fmt::format("--precise follows the driver for one picture; {}", kRemedy));
    if (const std::string why =
            as_page ? programmable::why_not_kept(scene.frame) : programmable::why_not_in_files(scene.frame);
        !why.empty())
        throw UsageError(fmt::format("{}: shaders to keep cannot draw this scene: {}; {}", scene.name(), why, kRemedy));
}

// The names of a scene's shapes by their places: "sphere" for glutSolidSphere. A recorded program has the names of its functions.
std::map<std::string, std::string> shape_names(const CommandList* list) {
    std::map<std::string, std::string> names;
    if (!list) return names;
    for (const Command& command : list->commands)
        for (const auto& [prefix, short_name] : {std::pair("glutSolid", ""), {"glutWire", "wire_"}, {"glu", ""}}) {
            const std::string_view name = command.name();
            if (command.sig().family != Family::kShape && command.sig().family != Family::kQuadric) break;
            if (!name.starts_with(prefix)) continue;
            std::string& shape = names[command.place.str()] = short_name;
            for (const char c : name.substr(std::string_view(prefix).size())) {
                const bool is_word = c >= 'A' && c <= 'Z';
                if (is_word && !shape.empty() && shape.back() != '_') shape += '_';
                shape += is_word ? static_cast<char>(c - 'A' + 'a') : c;
            }
            break;
        }
    return names;
}

// Writes the shaders to keep and the program that draws the scene with them. With --frames, `scene` has the first frame.
void write_kept(const Scene& scene, const programmable::Options& options, const ExportArguments& arguments) {
    const programmable::Glsl version = kVersions.at(arguments.glsl.empty() ? "330" : arguments.glsl);
    const std::map<std::string, std::string> shapes = shape_names(scene.recording->command_list());
    programmable::KeptScene kept;
    kept.name = scene.name();
    if (arguments.frames && arguments.frames->second > arguments.frames->first)
        kept.name = fmt::format("{} to {}", kept.name, arguments.frames->second);
    kept.name_of_shape = [&](const Place& place) {
        const auto found = shapes.find(place.str());
        return found == shapes.end() ? "" : found->second;
    };
    kept.for_each_frame = [&](const auto& visit) {
        const auto [first, last] = arguments.frames.value_or(std::pair(0, 0));
        if (last > first) later_frame(scene, last - first);  // an error before the work if there is no such frame
        visit(scene.frame, first);
        ProgressBar bar;
        for (int number = first + 1; number <= last; ++number) {
            bar.show(fmt::format("reading frame {}, up to {}", number, last));
            const Scene later = with_texels(later_frame(scene, number - first).scene, options);
            check_can_be_kept(later, options, false);
            visit(later.frame, number);
        }
    };
    write_folder_atomically(arguments.output, programmable::kept_files(kept, options, version));
}

// The same for WebGPU or Vulkan.
void write_ported(const Scene& scene, const programmable::Options& options, const ExportArguments& arguments) {
    std::vector<NamedFile> files;
    try {
        files = webgpu::ported_files(scene.frame, options, kTargets.at(arguments.form), scene.name());
    } catch (const std::runtime_error& why) {
        throw UsageError(
            fmt::format("{}: --as {} cannot draw this scene: {}; leave it out of the scene, or use --as glsl",
                        scene.name(), arguments.form, why.what()));
    }
    write_folder_atomically(arguments.output, files);
}

void check_usage(const ExportArguments& arguments) {
    const bool glsl = arguments.form == "glsl", html = arguments.form == "html", to_file = !arguments.output.empty();
    const bool ports = kTargets.contains(arguments.form);
    if (ports && !to_file)
        throw UsageError(fmt::format("--as {0} writes files; use it with --as {0} -o DIR", arguments.form));
    if (!glsl && !html && !ports && arguments.shading)
        throw UsageError(
            "--shading applies only to --as glsl, html, vulkan and wgsl; the other formats keep the scene's "
            "glShadeModel");
    if (!glsl && !html && !ports && arguments.precise)
        throw UsageError("--precise applies only to shaders; use it with --as glsl");
    if (!glsl && !html && !ports && to_file)
        throw UsageError("-o applies only to --as glsl, html, vulkan and wgsl; the other formats are printed");
    if (arguments.for_this_picture && (!glsl || to_file))
        throw UsageError("--for-this-picture prints shaders; use it with --as glsl, without -o");
    if (!arguments.glsl.empty() && (!glsl || !to_file))
        throw UsageError("--glsl applies only to shaders to keep; use it with --as glsl -o DIR");
    if (arguments.frames && (!glsl || !to_file))
        throw UsageError("--frames applies only to shaders to keep; use it with --as glsl -o DIR");
    if (arguments.frames && arguments.part.frame)
        throw UsageError("--frame and --frames choose the same thing; leave one of them out");
}

int run_export(ExportArguments arguments) {
    check_usage(arguments);
    if (arguments.frames) {
        arguments.part.frame = arguments.frames->first;
        arguments.part.is_of_several = true;
    }
    const bool to_file = !arguments.output.empty();
    const bool ports = kTargets.contains(arguments.form);
    const bool writes_texels = arguments.form == "html" || ports || (arguments.form == "glsl" && to_file);
    if (writes_texels) arguments.memory.bytes_of_pixel = arguments.memory.bytes_of_step_pixel = 40;
    const bool is_page = arguments.form == "html";
    // Loading runs the whole scene, so that a scene with an error is not exported.
    std::vector<Scene> scenes;
    if (is_page)
        scenes = load_steps(arguments.scene, {}, arguments.part, arguments.step, arguments.memory);
    else
        scenes.push_back(load_scene(arguments.scene, {}, arguments.part, arguments.step, arguments.memory));
    programmable::Options options{{{.shading = arguments.shading}}};
    options.precise = arguments.precise;
    if (writes_texels) {
        for (Scene& scene : scenes) scene = with_texels(std::move(scene), options);
        check_can_be_kept(scenes.front(), options, is_page || ports);
    }
    if (ports) {
        write_ported(scenes.front(), options, arguments);
        return kFine;
    }
    if (arguments.form == "glsl" && to_file) {
        write_kept(scenes.front(), options, arguments);
        return kFine;
    }
    const std::string text = is_page ? page_of(scenes, options) : kForms.at(arguments.form)(scenes.front(), options);
    if (to_file)
        write_file_atomically(arguments.output, text);
    else
        write_result(text);
    return kFine;
}

}  // namespace

Subcommand add_export(CLI::App& app) {
    const auto arguments = std::make_shared<ExportArguments>();
    CLI::App* exporting = app.add_subcommand("export",
                                             "Print a scene as a C program (freeglut), as the GLSL shaders that draw "
                                             "it, as a page that draws it with WebGL, as shaders for Vulkan or "
                                             "WebGPU, or as a scene file");
    add_scene_argument(*exporting, arguments->scene);
    exporting->add_option("--as", arguments->form, "output format")
        ->required()
        ->type_name("c|glsl|html|scene|vulkan|wgsl")
        ->check(one_of(kForms));
    add_shading_option(*exporting, arguments->shading);
    add_recorded_options(*exporting, arguments->part);
    add_step_option(*exporting, arguments->step);
    add_memory_option(*exporting, arguments->memory);
    add_precise_flag(*exporting, arguments->precise);
    exporting
        ->add_option(
            "-o", arguments->output,
            "with --as glsl: write shaders to keep into this folder; they stay right when objects, lights "
            "and the camera move. A C program that draws the scene with them is beside them. With --as vulkan and "
            "wgsl: the same for these, with the layout of their buffers and the scene as data. With --as html: the "
            "file (default: standard output), with all steps of the scene")
        ->type_name("PATH")
        ->check(not_empty());
    exporting->add_option("--glsl", arguments->glsl, "GLSL version of the shaders to keep (default: 330, core profile)")
        ->type_name("130|330|300es")
        ->check(one_of(kVersions));
    exporting
        ->add_option_function<std::string>(
            "--frames", [arguments](const std::string& text) { arguments->frames = read_frames(text); },
            "with --as glsl -o: these frames of a recorded program, with one set of shaders; the C program plays them")
        ->type_name("N-M")
        ->check(CLI::Validator(
            [](const std::string& text) {
                return read_frames(text) ? "" : fmt::format("'{}' is not a range of frames, such as 0-60", text);
            },
            ""));
    exporting->add_flag("--for-this-picture", arguments->for_this_picture,
                        "print shaders with only the effects that this picture needs, as without -o");
    return {exporting, [arguments] { return run_export(*arguments); }};
}

}  // namespace twinlight::cli
