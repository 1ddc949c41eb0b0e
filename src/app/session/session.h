// Session: what the window shows and what the user has chosen, as plain data. No GL, GLUT or ImGui here.
//
// The commands are the only truth about the scene: every key and every panel that changes the picture edits them
// (edits.h, camera.h), and what the window shows is what `twinlight render` would draw of the saved file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/history.h"
#include "app/session/probe_arrows.h"
#include "render/look.h"
#include "render/path.h"
#include "scene/frame/scene.h"

namespace twinlight::session {

// kSlider: two pictures, one on each side of a line that can be dragged. kGrid: three pictures and a difference.
// kWorld: the scene from outside, with its camera and lights. kTutor: that, a picture, and six calls (tutor.h).
enum class View : std::uint8_t { kSingle, kGrid, kSlider, kWorld, kTutor };
struct ViewName {
    View value;
    const char* key;
};
inline constexpr ViewName kViews[] = {{View::kSlider, "slider"},
                                      {View::kGrid, "grid"},
                                      {View::kSingle, "single"},
                                      {View::kWorld, "world"},
                                      {View::kTutor, "tutor"}};

// The tabs beside the pictures.
enum class Panel : std::uint8_t { kCommands, kLights, kProbe, kLint, kShaders, kOverlays, kAccuracy, kSave, kLesson };
struct PanelName {
    Panel value;
    const char* key;
    const char* title;
};
inline constexpr PanelName kPanels[] = {
    {Panel::kCommands, "commands", "Commands"}, {Panel::kLights, "lights", "Lights"},
    {Panel::kProbe, "probe", "Probe"},          {Panel::kLint, "lint", "Lint"},
    {Panel::kShaders, "shaders", "Shaders"},    {Panel::kOverlays, "overlays", "Overlays"},
    {Panel::kAccuracy, "accuracy", "Accuracy"}, {Panel::kSave, "save", "Save"},
    {Panel::kLesson, "lesson", "Lesson"}};

// One picture of the window.
struct Pane {
    Path renderer = Path::kFixed;
    std::optional<Shading> shading{};  // empty: flat or Gouraud, as the scene's glShadeModel says
    // The lecture's variants in the scene's pragmas. Empty: with lighting per pixel only, as `twinlight compare` does.
    std::optional<bool> lecture_variants{};

    friend bool operator==(const Pane&, const Pane&) = default;
};
inline constexpr std::size_t kPanes = 3;
inline constexpr std::size_t kDifferencePane = kPanes;  // the number of the difference, after those of the panes
inline constexpr std::size_t kWorldPane = kPanes + 1;   // the number of the scene from outside, in the tutor

enum class Wireframe : std::uint8_t { kOff, kOver, kAlone };
struct Overlays {
    Wireframe wireframe = Wireframe::kOff;
    bool normals = false;
    bool provoking_vertices = false;  // the vertices whose colour flat shading takes
    bool back_faces = false;
    bool above_one = false;    // where a channel exceeds 1 before it is clamped
    bool kept_lights = false;  // which lights the planner keeps for each object

    friend bool operator==(const Overlays&, const Overlays&) = default;
};

// The two panes that the slider and the difference compare.
struct Pair {
    std::size_t a = 0, b = 1;

    friend bool operator==(const Pair&, const Pair&) = default;
};

// What `twinlight explain` explains: a pixel of the picture (from the top left), or a vertex of a Draw (both count from 1).
struct Probe {
    bool is_vertex = false;
    int x = 0, y = 0;
    std::size_t draw = 1, vertex = 1;

    friend bool operator==(const Probe&, const Probe&) = default;
};

// Whose symbols the probe shows: "d_cm", "n.VP" or "k_d", "n·l" (docs/lecture.md).
enum class Symbols : std::uint8_t { kSpecification, kLecture };

struct LessonState;

// A scene with its own history and file. `opened` and its text stay as they were read, so that edits have places in them.
struct OpenScene {
    explicit OpenScene(std::shared_ptr<const CommandList> scene_opened, std::optional<std::string> scene_file = {});

    History history;
    std::shared_ptr<const CommandList> opened;  // as it was read; of a scene with steps, the step that is shown
    std::map<std::size_t, std::shared_ptr<const CommandList>> opened_steps{};  // the steps shown so far, by number
    std::optional<std::string> file{};         // empty for a built-in scene and standard input
    std::shared_ptr<const CommandList> saved;  // as the file has it now
    std::string file_text{};                   // the file's text when it was last read or written
};

// What is shown over the pictures, one at a time.
enum class Dialog : std::uint8_t { kNone, kMenu, kOpen, kSaveAs, kFind, kEnd, kFileChanged, kRecovered, kRecord };

struct Session : OpenScene {
    explicit Session(std::shared_ptr<const CommandList> scene_opened, std::optional<std::string> scene_file = {});

    std::map<std::string, OpenScene> others{};  // the scenes shown before, by key_of()

    // The commands as the panes draw them: those of history, with viewports for this size. Made by refresh().
    Scene scene{};
    int width = 0, height = 0;  // of a picture in pixels
    int made_from = -1;         // the revision of history that it was made from
    int revision = 0;           // counts the scenes made
    std::string error{};        // why the commands cannot be drawn; `scene` is then the last one that could

    View view = View::kSlider;
    // The first two differ in one thing only: where light is computed.
    std::array<Pane, kPanes> panes{Pane{Path::kFixed}, Pane{Path::kProgrammable, Shading::kPhong, false},
                                   Pane{Path::kReference}};
    std::size_t active = 1;  // the pane that Tab and g change; may be kDifferencePane
    Pair slider{0, 1}, difference{0, 2};
    double slider_at = 0.5;  // from the left edge: 0 to 1
    int amplification = 0;   // of the difference; 0: as large as keeps it below white
    Overlays overlays{};
    bool labels_shown = true;  // the scene's
    std::optional<Probe> probe{};
    Symbols symbols = Symbols::kSpecification;
    std::optional<ProbeArrows> probe_arrows{};  // its vectors, for the scene of their revision
    std::optional<int> selected_light{};
    std::optional<std::size_t> selected_command{};  // index into the commands

    bool keys_shown = false;
    Dialog dialog = Dialog::kNone;
    bool panel_shown = true;
    std::optional<double> panel_width{};  // in pixels at scale 1, once it was dragged
    Panel panel = Panel::kCommands;
    bool animating = false;
    // What moves does so from here, so that rounding does not add up. Begins again after any other edit.
    struct Animation {
        std::shared_ptr<const CommandList> from, last;
        Frame frame;
        double seconds = 0;
    };
    std::optional<Animation> animation{};
    std::shared_ptr<LessonState> lesson{};      // null outside lessons (lesson_state.h)
    std::vector<std::string> solved_lessons{};  // their names
    std::vector<std::string> recent_files{};    // with their folders, the last opened first (scenes.h)
    bool quit_requested = false;
    // Requests that the window carries out and clears.
    bool export_requested = false, screenshot_requested = false, save_requested = false, full_screen_requested = false;
    bool copy_requested = false, paste_requested = false;  // of the selected call
    std::optional<int> letters_requested{};                // 1: larger, -1: smaller, 0: as at the start
    bool tutor_requested = false;                          // the next one
    int scene_requested = 0;  // -1: the built-in scene before this one, 1: the one after it
    int step_requested = 0;   // -1: the scene's step before this one, 1: the one after it

    std::string message{};  // what just happened, for a few seconds
    int messages = 0;       // counts them
};

const CommandList& commands(const OpenScene& scene);
// Says something in the window's status line.
void say(Session& session, std::string message);
// Replaces the commands as one step of undo; see History::edit.
void edit(Session& session, CommandList commands, std::string what, std::string group = {});
// The file of a scene, or its name.
std::string key_of(const OpenScene& scene);
// For people: the file's name without its folder.
std::string title_of(const OpenScene& scene);
// Whether the scene has changes that its file lacks.
bool is_edited(const OpenScene& scene);
// The scenes with such changes; the one on show is the first.
std::vector<const OpenScene*> edited_scenes(const Session& session);
// Shows another scene. The views and panes stay, and `others` keeps the scene that was on show.
void open(Session& session, OpenScene scene);
void open(Session& session, std::shared_ptr<const CommandList> scene, std::optional<std::string> file);
// Shows the scene of `others` with this key again, with its history. Returns false if there is no such scene.
bool reopen(Session& session, const std::string& key);
// Ends the program, or asks first if that would lose changes.
void request_end(Session& session);

// The size in which the scene's own numbers are meant: a program's window, or 640 x 480.
WindowSize natural_size(const CommandList& commands);
// The commands for a picture of another size: all window coordinates are scaled. What is drawn for a texture, or into a
// framebuffer object, keeps its size.
CommandList scaled(const CommandList& commands, WindowSize from, WindowSize to);
// Makes `scene` again if the commands or the size changed. Returns whether the panes must draw again. An error goes to
// session.error.
bool refresh(Session& session, int width, int height);

// How a pane shades now: glShadeModel(GL_FLAT) makes every pane flat, and the fixed function has no lighting per pixel.
// Empty: as the scene says.
std::optional<Shading> shading_of(const Session& session, const Pane& pane);
Look look_of(const Session& session, const Pane& pane);
// The pane that the panels follow: the active one, or the last if the difference is active.
const Pane& active_pane(const Session& session);
inline constexpr std::array<const char*, kPaths> kRendererTitles = {"Fixed function", "Shaders", "Reference"};
// "Fixed function, Gouraud"
std::string title_of(const Session& session, const Pane& pane);
// "GL_SMOOTH, GL_LIGHT0, GL_LIGHT3 on": the shade models and lights of the frame.
std::string lights_summary(const Frame& frame);
// Whether all Draws of the frame have GL_FLAT (and there is one).
bool is_flat(const Frame& frame);

}  // namespace twinlight::session
