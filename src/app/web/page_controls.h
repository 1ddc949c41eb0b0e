// The keys and the mouse over the page's pictures. They do what they do in the window (app/session/keys.h), and the scene's text
// follows.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/keys.h"
#include "app/session/session.h"
#include "app/web/page_world.h"

namespace twinlight::web {

// JSON: [{"first", "last", "label", "what"}], the keys that the page has.
std::string page_keys();
// JSON: [{"name": "light", "text"}], the tutors' scenes.
std::string page_tutors();

// All functions return JSON:
//   {"known", "text", "shown", "message", "scene", "step", "exports", "keys"}
// known: false for a key without a function; text: the scene's text now; shown: the number of its step that is shown; message: what
// happened, or ""; scene, step: -1 or 1 asks for the one before or after; exports: asks for the C program; keys: asks for the list of keys.
class PageControls {
  public:
    using Read = std::function<CommandList(std::string_view text)>;

    // `read` reads a text as `opened` was read.
    PageControls(std::shared_ptr<const CommandList> opened, std::string text, WindowSize size, Read read);

    const std::string& text() const { return text_; }
    // Whether the session shows this text and step.
    bool shows(std::string_view text, std::size_t step) const;

    std::string press(int code);  // session::Key's codes
    // A drag moves the camera around the scene, or turns it if it looks. In pixels from the start of the drag, y down.
    void start_drag(bool may_go_under);
    std::string drag(bool looks, int dx, int dy);
    void end_drag() { session_.history.end_group(); }
    std::string zoom(int steps);  // of the wheel; positive is nearer

    // Three numbers of the scene's lighting to change, or fewer. JSON:
    //   [{"command", "argument", "name": "GL_LIGHT0 GL_POSITION x", "value", "smallest", "largest", "step"}]
    // smallest, largest: null without a limit; step: a sensible change for one pixel of a drag.
    std::string numbers() const;
    // The calls that the tutor shows (app/session/tutor.h). JSON, the parts of each:
    //   [[{"text": "glLightfv("}, {"text": "GL_LIGHT0", "help"}, {"text": "1", "help", "number": as in numbers(), "is_color"}]]
    std::string calls() const;
    // Changes of one argument that follow each other are one step of undo.
    std::string set_argument(std::size_t command, std::size_t argument, double value);

    // The scene from outside.
    webgl::WebglFrame world() { return world_.frame(session_); }
    void press_world(int x, int y);
    std::string drag_world(int dx, int dy);
    std::string zoom_world(int steps);

  private:
    struct Number {
        std::size_t command = 0, argument = 0;
    };
    std::vector<Number> found_numbers() const;

    std::string answer(bool known);
    void follow();

    session::Session session_;
    session::DragStart drag_start_{};
    PageWorld world_{};
    const std::string opened_text_;
    std::string text_;
    int text_of_ = 0;   // the revision of the session's history that text_ is of
    int messages_ = 0;  // those that the page has had
    const Read read_;
};

}  // namespace twinlight::web
