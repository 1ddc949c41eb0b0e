#include "app/session/saving.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "app/session/edited_text.h"
#include "app/session/merge.h"
#include "base/image/file.h"
#include "base/image/named_file.h"
#include "base/text/translation.h"
#include "render/programmable/export/kept_code.h"
#include "render/programmable/export/kept_files.h"
#include "render/webgl/exported_page.h"
#include "scene/command/text.h"
#include "scene/scenes/caption.h"
#include "scene/scenes/load.h"
#include "scene/shape/written_out.h"

namespace twinlight::session {
namespace {

namespace fs = std::filesystem;

std::string step_of(const CommandList& list) { return list.step == 0 ? "" : std::to_string(list.step); }

CommandList read_as(const OpenScene& scene, const std::string& text, const std::string& step) {
    return read_text_of(scene.file.value_or(""), scene.opened->name, text, step);
}

// The file has this text from now on. Its other steps are other commands then.
void set_saved(OpenScene& scene, const std::string& text) {
    scene.file_text = text;
    scene.saved = scene.history.now();
    for (auto& [number, step] : scene.opened_steps)
        if (number != scene.opened->step)
            step = std::make_shared<const CommandList>(read_as(scene, text, std::to_string(number)));
}

// Writes this text into the scene's file.
void write(OpenScene& scene, const std::string& text) {
    write_file_atomically(*scene.file, text);
    set_saved(scene, text);
}

// text_now(), or the commands one by one if that is empty.
std::string or_printed(const std::optional<std::string>& text, const OpenScene& scene) {
    return text ? *text : print_scene(commands(scene));
}

// why_not: why the scene cannot be saved so; empty if it can.
void check_can_be_kept(const std::string& why_not, const Look& look) {
    if (look.shading == Shading::kExact)
        throw std::runtime_error(
            tr("exact surfaces are found by rays for one picture; choose another shading (key g) for shaders to keep"));
    if (!why_not.empty()) throw std::runtime_error(tr("shaders to keep cannot draw this scene: {}", why_not));
}

}  // namespace

std::string stem_of(const std::string& scene) {
    std::string stem = scene == "-" ? "stdin" : fs::path(scene).stem().string();
    return stem.empty() ? "scene" : stem;
}

std::string free_path(const std::string& folder, const std::string& stem, const std::string& ending) {
    for (int number = 1;; ++number) {
        const std::string name = number == 1 ? stem + ending : fmt::format("{}-{}{}", stem, number, ending);
        const std::string path = folder.empty() ? name : (fs::path(folder) / name).string();
        std::error_code ignored;
        if (!fs::exists(fs::symlink_status(path, ignored))) return path;
    }
}

std::optional<std::string> text_now(const OpenScene& scene) {
    const CommandList &opened = *scene.opened, &now = commands(scene);
    if (!opened.text) return {};
    // An undone step may be one of another text.
    return edited_text(*opened.text, opened, now.text == opened.text ? now : with_places_of(opened, now),
                       [&](std::string_view text) { return read_as(scene, std::string(text), step_of(opened)); });
}

std::string text_to_save(const OpenScene& scene) { return or_printed(text_now(scene), scene); }

void save(OpenScene& scene) {
    const std::optional<std::string> text = text_now(scene);
    if (!text)
        throw std::runtime_error(
            tr("the changes do not fit into the text of {}, for example because they are in a loop; save the "
               "scene as another file (Ctrl+Shift+S)",
               *scene.file));
    write(scene, *text);
}

void save_as(Session& session, const std::string& path) {
    if (path.empty()) throw std::runtime_error(tr("type a file's name"));
    const std::optional<std::string> fitting = text_now(session);
    const std::string text = or_printed(fitting, session);
    // Its pictures and meshes must be there, too.
    auto list =
        std::make_shared<const CommandList>(read_text_of(path, session.opened->name, text, step_of(commands(session))));
    write_file_atomically(path, text);
    session.others.erase(path);
    if (!fitting) {
        open(session, std::move(list), path);
        return;
    }
    session.file = path;
    set_saved(session, text);
}

std::string save_all(Session& session, const std::string& folder) {
    std::string said;
    const auto save_one = [&](OpenScene& scene) {
        if (!is_edited(scene)) return;
        std::string path = scene.file.value_or("");
        const std::optional<std::string> fitting = text_now(scene);
        if (!path.empty() && fitting) {
            write(scene, *fitting);
        } else {
            // A scene names its pictures and meshes relative to its own folder.
            path =
                free_path(path.empty() ? folder : fs::path(path).parent_path().string(), stem_of(key_of(scene)), ".gl");
            write_file_atomically(path, or_printed(fitting, scene));
            scene.saved = scene.history.now();
        }
        said += (said.empty() ? "" : tr(", ")) + path;
    };
    save_one(session);
    for (auto& [key, scene] : session.others) save_one(scene);
    return said.empty() ? "" : tr("saved {}", said);
}

void take_file_text(Session& session, const std::string& theirs) {
    if (theirs == session.file_text) return;
    auto list = std::make_shared<const CommandList>(read_as(session, theirs, ""));
    const std::size_t step = commands(session).step;
    if (step > 1 && step <= list->steps.size())
        list = std::make_shared<const CommandList>(read_as(session, theirs, std::to_string(step)));
    OpenScene changed(list, session.file);
    if (!is_edited(session)) {
        open(session, std::move(changed));
        say(session, tr("read again: {}", *session.file));
        return;
    }
    CommandList mine = commands(session);
    bool is_merged = false;
    if (const auto my_text = text_now(session)) {
        if (const auto text = merged(session.file_text, *my_text, theirs)) {
            try {
                mine = read_as(session, *text, step_of(*list));
                is_merged = true;
            } catch (const SceneError&) {  // each change by itself was right
            }
        }
    }
    changed.history.edit(with_places_of(*list, std::move(mine)), tr("your changes"));
    open(session, std::move(changed));
    if (is_merged)
        say(session, tr("read again: {}; your changes are kept, z shows the file without them", *session.file));
    else
        session.dialog = Dialog::kFileChanged;
}

std::string save(const Session& session, Form form, const Look& look, const std::string& folder) {
    const CommandList& list = commands(session);
    const Frame& frame = session.scene.frame;
    const Caption caption = caption_of(list);
    const std::string ending = kForms[static_cast<std::size_t>(form)].ending;
    const std::string path = free_path(folder, stem_of(key_of(session)), ending);
    switch (form) {
        case Form::kC: write_file_atomically(path, print_c_program(with_pragmas_written_out(list))); break;
        case Form::kHtml:
            check_can_be_kept(programmable::why_not_kept(frame), look);
            write_file_atomically(path,
                                  webgl::exported_page({{&frame}}, look, {list.name, caption.title, caption.notice}));
            break;
        case Form::kGlsl: {
            check_can_be_kept(programmable::why_not_in_files(frame), look);
            const auto files = programmable::kept_files(frame, {{look}}, programmable::Glsl::k330, list.name);
            write_folder_atomically(path, files);
            return tr("wrote {}/ with {} files; README.md explains them", path, files.size());
        }
    }
    return tr("wrote {}, {} bytes", path, fs::file_size(path));
}

}  // namespace twinlight::session
