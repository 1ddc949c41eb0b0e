#include "app/session/session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "base/text/translation.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::session {

OpenScene::OpenScene(std::shared_ptr<const CommandList> scene_opened, std::optional<std::string> scene_file)
    : history(scene_opened),
      opened(std::move(scene_opened)),
      opened_steps{{opened->step, opened}},
      file(std::move(scene_file)),
      saved(opened),
      file_text(opened->text ? *opened->text : "") {}

Session::Session(std::shared_ptr<const CommandList> scene_opened, std::optional<std::string> scene_file)
    : OpenScene(std::move(scene_opened), std::move(scene_file)) {}

const CommandList& commands(const OpenScene& scene) { return *scene.history.now(); }

void say(Session& session, std::string message) {
    session.message = std::move(message);
    ++session.messages;
}

void edit(Session& session, CommandList commands, std::string what, std::string group) {
    session.history.edit(std::move(commands), std::move(what), std::move(group));
}

std::string key_of(const OpenScene& scene) { return scene.file.value_or(scene.opened->name); }

std::string title_of(const OpenScene& scene) {
    return scene.file ? one_line(std::filesystem::path(*scene.file).filename().string()) : scene.opened->name;
}

bool is_edited(const OpenScene& scene) {
    const CommandList& now = commands(scene);
    // Another step of the scene has the camera of the one before; its other commands are the file's.
    return now.commands != (now.step == scene.saved->step ? scene.saved : scene.opened)->commands;
}

std::vector<const OpenScene*> edited_scenes(const Session& session) {
    std::vector<const OpenScene*> scenes;
    if (is_edited(session)) scenes.push_back(&session);
    for (const auto& [key, scene] : session.others)
        if (is_edited(scene)) scenes.push_back(&scene);
    return scenes;
}

void open(Session& session, OpenScene scene) {
    const int revision = session.history.revision();
    session.others.insert_or_assign(key_of(session), static_cast<const OpenScene&>(session));
    session.others.erase(key_of(scene));
    static_cast<OpenScene&>(session) = std::move(scene);
    session.history.count_from(revision + 1);
    session.error.clear();
    session.probe.reset();
    session.selected_light.reset();
    session.selected_command.reset();
}

void open(Session& session, std::shared_ptr<const CommandList> scene, std::optional<std::string> file) {
    open(session, OpenScene(std::move(scene), std::move(file)));
}

bool reopen(Session& session, const std::string& key) {
    const auto found = session.others.find(key);
    if (found == session.others.end()) return false;
    open(session, OpenScene(std::move(found->second)));
    return true;
}

void request_end(Session& session) {
    if (edited_scenes(session).empty())
        session.quit_requested = true;
    else
        session.dialog = Dialog::kEnd;
}

WindowSize natural_size(const CommandList& commands) { return commands.window.value_or(WindowSize{}); }

bool refresh(Session& session, int width, int height) {
    if (session.made_from == session.history.revision() && session.width == width && session.height == height)
        return false;
    const bool resized = session.width != width || session.height != height;
    session.made_from = session.history.revision();
    session.width = width;
    session.height = height;
    const CommandList& list = commands(session);
    StateOptions options;
    options.width = width;
    options.height = height;
    try {
        session.scene =
            make_scene(std::make_shared<const CommandList>(scaled(list, natural_size(list), {width, height})), options);
        session.error.clear();
    } catch (const SceneError& error) {
        session.error = error.what();
        if (!resized) return false;
    }
    ++session.revision;
    return true;
}

bool is_flat(const Frame& frame) {
    const auto draws = frame.draws();
    return !draws.empty() &&
           std::ranges::all_of(draws, [](const Draw* draw) { return draw->lighting.shade_model == kGL_FLAT; });
}

std::string lights_summary(const Frame& frame) {
    std::set<std::string> shade_models;
    std::set<int> lights;
    for (const Draw* draw : frame.draws()) {
        shade_models.insert(draw->lighting.shade_model == kGL_FLAT ? "GL_FLAT" : "GL_SMOOTH");
        for (std::size_t i = 0; i < draw->lighting.lights.size(); ++i)
            if (draw->lighting.enabled && draw->lighting.lights[i].enabled) lights.insert(static_cast<int>(i));
    }
    std::string text = fmt::format("{}", fmt::join(shade_models, tr(" and ")));
    if (lights.empty()) return text + tr(", no light is on");
    if (lights.size() > kMaxLights) return text + tr(", {} lights on", lights.size());
    for (const int light : lights) text += tr(", ") + light_name(light);
    return text + tr(" on");
}

std::optional<Shading> shading_of(const Session& session, const Pane& pane) {
    if (!pane.shading) return {};
    if (pane.renderer == Path::kFixed && lights_every_pixel(pane.shading)) return {};
    if (is_flat(session.scene.frame)) return {};
    return pane.shading;
}

Look look_of(const Session& session, const Pane& pane) {
    const std::optional<Shading> shading = shading_of(session, pane);
    return {shading, pane.lecture_variants.value_or(lights_every_pixel(shading))};
}

const Pane& active_pane(const Session& session) { return session.panes[std::min(session.active, kPanes - 1)]; }

std::string title_of(const Session& session, const Pane& pane) {
    const char* const renderer = tr(kRendererTitles[static_cast<std::size_t>(pane.renderer)]);
    const Shading first = is_flat(session.scene.frame) ? Shading::kFlat : Shading::kGouraud;
    switch (shading_of(session, pane).value_or(first)) {
        case Shading::kFlat: return tr("{}, flat", renderer);
        case Shading::kGouraud: return tr("{}, Gouraud", renderer);
        case Shading::kPhong: return tr("{}, Phong", renderer);
        case Shading::kExact: return tr("{}, exact surfaces", renderer);
    }
    return renderer;
}

}  // namespace twinlight::session
