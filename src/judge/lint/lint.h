// The linter: warns about mistakes in lighting that GL accepts without an error.
//
// A rule watches the commands, the state while they run, the Draws, and the finished Frame. rules() is the table;
// docs/lint.md is generated from it.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/frame/scene.h"

namespace twinlight::lint {

class Watch;

struct Rule {
    std::string_view name;   // "light-before-camera"
    std::string_view what;   // what is wrong: a sentence
    std::string_view why;    // the reason, with the section of GL 2.1: sentences
    std::string_view fix;    // the call to write
    std::string_view scene;  // a small scene as a diff: lines that start with "-" are wrong, with "+" corrected
    std::unique_ptr<Watch> (*make)();
    std::vector<std::string_view> explained_by{};  // rules whose mistakes cause this one: it warns only without them
    bool compares_pictures = false;                // its messages say which pictures are wrong
};

std::span<const Rule> rules();
const Rule* find_rule(std::string_view name);  // null if there is none

// The two scenes of a rule, whole: with the mistake, and corrected.
std::string wrong_scene(const Rule& rule);
std::string corrected_scene(const Rule& rule);
// What a rule's pictures show: the scene, or the second picture of a whole program.
Frame shown_frame(const Scene& scene);

// One change of a scene's text, at the statement that starts at `place`.
struct Edit {
    Place place;
    bool removes = false;   // removes the statement
    std::string insert{};   // writes this statement: before it, or instead of it if it is removed
    bool is_after = false;  // writes it after the statement
    Place moved{};          // writes the statement at this place and removes it there, instead of `insert`
};

struct Warning {
    const Rule* rule = nullptr;
    Place place;
    std::string message;  // what is wrong here, with numbers
    std::string fix;      // the call to write here
    std::vector<Edit> edits{};
    int count = 1;       // how often; `place` is the first
    std::string when{};  // in which pictures of a program, if not in all: "from the second picture on"
    Place draw{};        // the statement of the Draw that it is about; line 0 if it is not about one
    std::string key{};   // warnings of a rule with the same key are one; empty: the message
};

// A later picture of a scene. Its recording starts where the scene's starts, with Step::Kind::kFrameEnd after each picture before it.
struct LaterScene {
    Scene scene;
    std::string when;     // "in the second picture"
    bool is_next = true;  // the second picture; others may be any that people can see
};

// Those of a whole program: its second picture, one after a second, one after a key. None for other scenes.
std::vector<LaterScene> later_scenes(const Scene& scene);

// All warnings of a scene and its later pictures, in the order of their places. Comments of its text silence rules: `// twinlight:
// allow(name)` on a line of its own for the whole text, at the end of a line for that line.
// A mistake of the second picture is a warning that says so. One of a later picture is, too, if the first two do not run its
// statement: what people see after a second or a key may be meant.
std::vector<Warning> lint(const Scene& scene, std::span<const LaterScene> later);
inline std::vector<Warning> lint(const Scene& scene) { return lint(scene, later_scenes(scene)); }

// ---- Output (warnings.cpp) ----

// The message, and in which pictures: "GL_LIGHT1 is on but black (after 1 s)".
std::string message_of(const Warning& warning);
// "scene.gl:7:1: warning: message [name]"
std::string headline(const Warning& warning);
// As compilers print it: the headline, the line of the text with a caret, the reason and the fix. With `calls`, also the chain
// of calls that led to a place of a recorded program.
std::string full_text(const Warning& warning, std::string_view source, bool calls = false);
// {"scene", "warnings": [{"name", "file", "line", "column", "calls", "count", "when", "message", "why",
// "fix"}]}. "when" is null for a mistake of all pictures. Only places in the
// source of a recorded program have "calls"; without call stacks, `line` is the number of the call and `column` is null.
std::string json_text(const std::string& scene, std::span<const Warning> warnings);
// docs/lint.md.
std::string markdown();

// ---- Source text (source.cpp) ----

// The scene's text with the edits of a warning.
std::string corrected(std::string_view source, const Warning& warning);

}  // namespace twinlight::lint
