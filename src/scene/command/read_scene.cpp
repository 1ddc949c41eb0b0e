// read_scene: decides whether a text is a scene or a whole program, and reads a scene's steps.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "scene/command/characters.h"
#include "scene/command/cpp_words.h"
#include "scene/command/preprocess.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

void check_short_text(const Place& place, std::string_view what, std::string_view text) {
    if (text.size() > kMaxStepTitleBytes)
        fail(place, "{} can have at most {} bytes; this one has {}", what, kMaxStepTitleBytes, text.size());
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t bytes = decode_utf8(rest).bytes;
        if (bytes == 0) fail(place, "{} is not UTF-8; save the scene as UTF-8 text", what);
        rest.remove_prefix(bytes);
    }
}

namespace {

void check_title(const Token& token, std::string_view title) {
    check_short_text(token.place, tr("a step's title"), title);
    if (title.find_first_not_of("0123456789") == std::string_view::npos)
        fail(token.place, "a step needs a title in words, such as \"Diffuse only\"; its number follows from its place");
}

}  // namespace

// #pragma twinlight step("Diffuse only"): the lines after it belong to that step only; step() ends them. Skips the lines of
// the steps that are not read.
void Reader::step_pragma() {
    const Token pragma_name = token_;
    if (program_)
        fail(pragma_name.place,
             "a program with main cannot have steps; put the calls of its display function into a scene");
    advance();
    expect("(", "after #pragma twinlight step");
    std::size_t number = step_;  // step() belongs to every step
    if (!token_.is(")")) {
        const Token token = token_;
        if (token.kind != TokenKind::kString)
            fail(token.place, "expected the step's title in quotes, such as \"Diffuse only\", found {}", shown(token));
        const std::string_view title = token.text.substr(1, token.text.size() - 2);
        check_title(token, title);
        advance();
        const auto found = std::ranges::find(steps_, title);
        number = static_cast<std::size_t>(found - steps_.begin()) + 1;
        if (found == steps_.end()) steps_.emplace_back(title);
        if (steps_.size() > kMaxSceneSteps) fail(token.place, "a scene can have at most {} steps", kMaxSceneSteps);
    }
    expect(")", "after the step's title");
    expect(";", "or the end of the line after step(...)");
    if (number == step_) return;
    while (token_.kind != TokenKind::kEnd && !(token_.kind == TokenKind::kPragma && ahead_.is("step"))) advance();
}

ImageFile no_images(const std::string&) {
    throw std::runtime_error(
        tr("this scene has no folder to read the picture from; save the scene in a file next to the picture"));
}

std::shared_ptr<const Mesh> no_meshes(const std::string&) {
    throw std::runtime_error(
        tr("this scene has no folder to read the mesh from; save the scene in a file next to the mesh"));
}

namespace {

bool is_program(const std::vector<Token>& tokens) {
    std::size_t depth = 0;
    bool has_main = false, has_loop = false;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (tokens[i].is("{")) ++depth;
        if (tokens[i].is("}") && depth > 0) --depth;
        has_main |= depth == 0 && tokens[i].is("main") && tokens[i + 1].is("(");
        has_loop |= tokens[i].is("glutMainLoop") || tokens[i].is("glutMainLoopEvent");
    }
    return has_main && has_loop;
}

std::string cpp_message(const CppWord& word, const std::string& file, const SceneError& as_c) {
    return tr(
        "this is C++: {}; Twinlight can read only C; run and record it: twinlight record {}; or run and lint it: "
        "twinlight lint --run {} "
        "(as C it fails in line {})",
        word.text, file, file, as_c.errors.front().place.line);
}

// Whether a text without main has the lines of a program rather than of a scene.
bool is_part_of_program(std::string_view text) {
    const auto has = [&](std::string_view words) { return text.find(words) != std::string_view::npos; };
    return !has("main(") && !has("main (") && has("#include");
}

// Reads a text that waits in GLUT's loop; nullopt if it is not a whole program.
std::optional<CommandList> read_program(const std::shared_ptr<const std::string>& text, const std::string& file,
                                        const std::string& name, const ImageLoader& load_image,
                                        const ReadOptions& options) {
    PreprocessedText program;
    try {
        program = preprocess(*text, file, options.load_text);
        if (!is_program(program.tokens)) return {};
        CommandList commands = Reader(std::move(program.tokens), file, load_image, options).run(name);
        commands.text = text;
        for (const auto& [included, its_text] : program.included)
            commands.included[included] = std::make_shared<const std::string>(its_text);
        return commands;
    } catch (const SceneError& error) {
        if (error.errors.empty()) throw;
        const Place& place = error.errors.front().place;
        if (const auto word = first_cpp_word(*text, file))
            throw SceneError(std::vector{TextError{word->place, cpp_message(*word, file, error)}}, text);
        const auto included = place.file ? program.included.find(*place.file) : program.included.end();
        throw SceneError(error.errors, included == program.included.end()
                                           ? text
                                           : std::make_shared<const std::string>(included->second));
    }
}

[[noreturn]] void fail_no_step(const std::string& file, const std::string& step,
                               const std::vector<std::string>& titles) {
    if (titles.empty()) throw SceneError(tr("{}: this scene has no steps; leave out --step", one_line(file)));
    std::string list;
    for (std::size_t i = 0; i < titles.size(); ++i)
        list += fmt::format("{}{} \"{}\"", i == 0 ? "" : ", ", i + 1, titles[i]);
    throw SceneError(tr("{}: this scene has no step {}; its steps are {}", one_line(file), in_quotes(step), list));
}

// The number of the step that ReadOptions::step names; nullopt if there is none.
std::optional<std::size_t> chosen_step(const std::string& step, const std::vector<std::string>& titles) {
    if (step.empty()) return 1;
    for (std::size_t i = 0; i < titles.size(); ++i)
        if (step == titles[i] || step == std::to_string(i + 1)) return i + 1;
    return {};
}

// Loads each mesh once, however many steps draw it.
MeshLoader once_each(const MeshLoader& load) {
    return [&load,
            meshes = std::make_shared<std::map<std::string, std::shared_ptr<const Mesh>>>()](const std::string& name) {
        auto found = meshes->find(name);
        if (found == meshes->end()) found = meshes->emplace(name, load(name)).first;
        return found->second;
    };
}

}  // namespace

CommandList read_scene(std::string_view text, const std::string& file, const std::string& name,
                       const ImageLoader& load_image, const ReadOptions& options) {
    if (text.size() > kMaxSceneBytes) {
        throw SceneError(tr("{}: this scene has {} bytes; the limit is {}", file, text.size(), kMaxSceneBytes));
    }
    const auto kept = std::make_shared<const std::string>(text);
    // A whole program has the function main and waits in GLUT's loop. What 'twinlight export --as c' prints has them too,
    // but only its function draw_scene is the scene.
    if (text.find("glutMainLoop") != text.npos && text.substr(0, 400).find(kPrintedProgram) == text.npos) {
        std::optional<CommandList> program = read_program(kept, file, name, load_image, options);
        if (program && !options.step.empty()) fail_no_step(file, options.step, {});
        if (program) return std::move(*program);
    }
    // A scene with steps is read once for each, so that an error in any of them shows.
    CommandList result(name, {});
    result.text = kept;
    std::vector<TextError> errors;
    std::set<std::tuple<int, int, std::string>> reported;  // an error of several steps shows once
    std::optional<std::size_t> chosen;
    ReadOptions options_of_steps = options;
    options_of_steps.load_mesh = once_each(options.load_mesh);
    for (std::size_t step = 1; step <= std::max<std::size_t>(1, result.steps.size()); ++step) {
        Reader reader(*kept, file, load_image, options_of_steps, step);
        std::vector<Command> commands = reader.read();
        if (step == 1) {
            result.steps = reader.steps();
            chosen = chosen_step(options.step, result.steps);
            if (!chosen && reader.errors().empty()) fail_no_step(file, options.step, result.steps);
            if (text.size() * result.steps.size() > kMaxSceneBytes)
                throw SceneError(tr("{}: a scene with {} steps can have at most {} bytes; this one has {}", file,
                                    result.steps.size(), kMaxSceneBytes / result.steps.size(), text.size()));
        }
        if (step == chosen) {
            result.commands = std::move(commands);
            result.window = reader.window();
        }
        for (TextError error : reader.errors()) {
            if (!reported.emplace(error.place.line, error.place.column, error.message).second) continue;
            if (step > 1) error.message += tr(" (in step {}, \"{}\")", step, result.steps[step - 1]);
            errors.push_back(std::move(error));
        }
    }
    if (!result.steps.empty()) result.step = chosen.value_or(1);
    if (errors.empty()) return result;
    SceneError error(std::move(errors), kept);
    if (is_part_of_program(text))
        error.note = tr(
            "this file has no function main(), so it is read as a scene; to read a program, give its file with main()");
    error.readable = std::make_shared<const CommandList>(std::move(result));
    throw error;
}

}  // namespace twinlight
