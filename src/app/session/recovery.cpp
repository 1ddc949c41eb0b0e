#include "app/session/recovery.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <memory>
#include <utility>

#include "app/session/edited_text.h"
#include "app/session/preferences.h"
#include "app/session/saving.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "base/text/translation.h"
#include "scene/scenes/load.h"

namespace twinlight::session {
namespace {

constexpr std::string_view kRecoveryName = "unsaved-";  // then the number of the process

std::string title_in(const Json& scene) {
    const std::string file = scene.at("file");
    return file.empty() ? scene.at("name").get<std::string>() : std::filesystem::path(file).filename().string();
}

// Whether the process that wrote this file still runs.
bool is_in_use(const std::filesystem::path& path) {
    const std::string process = path.stem().string().substr(kRecoveryName.size());
    try {
        return read_file("/proc/" + process + "/comm") == "twinlight-demo\n";
    } catch (const FileError&) {
        return false;
    }
}

// "on 3 May at 14:32"
std::string time_text(std::filesystem::file_time_type::duration since_now) {
    const std::time_t at = std::time(nullptr) + std::chrono::duration_cast<std::chrono::seconds>(since_now).count();
    std::tm local{};
    ::localtime_r(&at, &local);
    char text[64];
    return {text, std::strftime(text, sizeof text, tr("on %e %B at %H:%M"), &local)};
}

Json read_recovery(const std::string& path) {
    Json scenes = parsed_json(read_file(path));
    if (!scenes.is_array()) throw FileError(tr("{}: is not a recovery file; remove it", path));
    return scenes;
}

}  // namespace

std::string recovery_folder() { return users_folder("XDG_STATE_HOME", ".local/state"); }

RecoveryFile::RecoveryFile(std::string folder)
    : path_(folder.empty() ? "" : fmt::format("{}/{}{}.json", folder, kRecoveryName, ::getpid())) {}

void RecoveryFile::keep(const Session& session) {
    if (path_.empty()) return;
    Json scenes = Json::array();
    for (const OpenScene* scene : edited_scenes(session))
        scenes.push_back({{"file", scene->file ? std::filesystem::absolute(*scene->file).string() : ""},
                          {"name", scene->opened->name},
                          {"step", scene->opened->step},
                          {"opened", scene->file_text},
                          {"text", text_to_save(*scene)}});
    if (scenes.empty()) {
        remove();
        return;
    }
    try {
        const std::string bytes = dumped(scenes);
        write_files_atomically({{path_, bytes}}, {}, MissingFolders::kMade);
        exists_ = true;
    } catch (const FileError&) {
        path_.clear();  // a full disk, or a home that cannot be written
    }
}

void RecoveryFile::remove() {
    std::error_code ignored;
    if (std::exchange(exists_, false)) std::filesystem::remove(path_, ignored);
}

std::optional<LostScenes> find_lost_scenes(const std::string& folder) {
    std::filesystem::path newest;
    std::filesystem::file_time_type when{};
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (!entry.path().filename().string().starts_with(kRecoveryName) || is_in_use(entry.path())) continue;
        const auto time = entry.last_write_time(error);
        if (error || (!newest.empty() && time <= when)) continue;
        newest = entry.path();
        when = time;
    }
    if (newest.empty()) return {};
    try {
        std::vector<std::string> titles;
        for (const Json& scene : read_recovery(newest.string())) titles.push_back(title_in(scene));
        const auto since_now = when - std::filesystem::file_time_type::clock::now();
        return LostScenes{newest.string(), fmt::format("{}, {}", fmt::join(titles, ", "), time_text(since_now))};
    } catch (const std::exception&) {  // not ours
        return {};
    }
}

void restore(Session& session, const LostScenes& lost) {
    for (const Json& json : read_recovery(lost.path)) {
        std::string file = json.at("file");
        // As it was opened, so that it is the same scene.
        if (session.file && std::filesystem::absolute(*session.file).string() == file) file = *session.file;
        const std::string name = json.at("name"), text = json.at("text");
        const std::string step = json.at("step") == 0 ? "" : dumped(json.at("step"));
        const auto opened = std::make_shared<const CommandList>(read_text_of(file, name, json.at("opened"), step));
        OpenScene scene(opened, file.empty() ? std::nullopt : std::optional(file));
        scene.history.edit(with_places_of(*opened, read_text_of(file, name, text, step)), tr("the recovered changes"));
        open(session, std::move(scene));
    }
    forget(lost);
    say(session, tr("recovered: {}", lost.summary));
}

void forget(const LostScenes& lost) {
    std::error_code ignored;
    std::filesystem::remove(lost.path, ignored);
}

}  // namespace twinlight::session
