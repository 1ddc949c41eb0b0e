// Rules about a whole program's next picture: GLUT calls the display function again, and the first picture is still there.
#include "judge/lint/redraw.h"

#include <algorithm>
#include <cmath>

#include "base/text/translation.h"
#include "judge/lint/watch.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"

namespace twinlight::lint {

std::optional<Redraw> redraw_of(const CommandList& list, int width, int height) {
    if (!list.later) return std::nullopt;
    const LaterPicture& next = list.later->front();
    State state({.width = width, .height = height});
    for (const Command& command : list.commands) state.apply(command);
    Redraw redraw{.start = next.start, .clear_color = state.attributes().clear.clear_color};
    redraw.second = state.items().size();
    for (const Command& command : next.commands) {
        state.apply(command);
        if (is_effect(command, "clear")) redraw.clear = command;
    }
    if (state.exhausted() || state.unfinished()) return std::nullopt;
    redraw.frame = state.take_frame();
    // What only the driver draws may cover the first picture.
    if (!redraw.frame.unsupported.empty()) return std::nullopt;
    return redraw;
}

bool Redraw::clears_before_drawing(Buffer buffer) const {
    for (std::size_t i = second; i < frame.items.size(); ++i) {
        const Clear* const clears = std::get_if<Clear>(&frame.items[i]);
        if (!clears) return false;
        const bool is_whole = !clears->scissor.enabled && clears->color_mask == std::array{true, true, true, true};
        if (is_whole && (buffer == Buffer::kColor ? clears->color : clears->depth)) return true;
    }
    return true;  // it draws nothing
}

// Draws the second picture twice: once over the first, once over a buffer that was cleared. The other buffer is cleared
// both times.
bool Redraw::shows_first(Buffer buffer) const {
    if (clears_before_drawing(buffer)) return false;
    const Frame small = smaller(frame);
    const auto drawn_after = [&](const Clear& first) {
        Frame whole = small;
        whole.items.insert(whole.items.begin() + static_cast<std::ptrdiff_t>(second), first);
        return reference::render(whole, {});
    };
    const bool is_color = buffer == Buffer::kColor;
    const Image over = drawn_after({.color = !is_color, .depth = is_color, .clear_color = clear_color});
    const Image cleared = drawn_after({.color = true, .depth = true, .clear_color = clear_color});
    constexpr float kVisible = 10.0F / 255;
    return differing_pixels(over, cleared, kVisible) * 200 > over.pixels.size();
}

Frame shown_frame(const Scene& scene) {
    const CommandList* const list = scene.recording->command_list();
    std::optional<Redraw> redraw = list ? redraw_of(*list, scene.frame.width, scene.frame.height) : std::nullopt;
    return redraw ? std::move(redraw->frame) : scene.frame;
}

Warning not_cleared(const Redraw& redraw, Enum bits, std::string message) {
    Warning warning{.place = redraw.start, .message = std::move(message), .fix = {}};
    const Enum depth =
        std::ranges::any_of(redraw.frame.draws(), [](const Draw* draw) { return draw->raster.depth_test; })
            ? kGL_DEPTH_BUFFER_BIT
            : 0;
    const Enum before = redraw.clear ? redraw.clear->enumerant(0) : 0;
    warning.fix = fmt::format("glClear({});", bit_names(before | bits | depth));
    if (redraw.clear) warning.place = redraw.clear->place;
    warning.edits = {{.place = warning.place, .removes = redraw.clear.has_value(), .insert = warning.fix}};
    return warning;
}

namespace {

class ColorsNotCleared : public Watch {
    void redrawn(const Redraw& redraw) override {
        if (redraw.shows_first(Redraw::Buffer::kColor))
            warn(not_cleared(redraw, kGL_COLOR_BUFFER_BIT,
                             tr("the colours are not cleared: the second picture is drawn over the first, which still "
                                "shows")));
    }
};

}  // namespace

std::vector<Rule> redraw_rules() {
    return {
        {"colors-not-cleared",
         "The display function of a program does not clear the colours. Each picture is drawn over the one before. "
         "(The pictures here show the second call.)",
         "Section 4.2.3: the colour buffer keeps its contents until `glClear` clears them; after `glutSwapBuffers` "
         "they "
         "are undefined.",
         "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);",
         R"( #include <GL/glut.h>
 double x = -1.2;
 void display(void) {
-    glClear(GL_DEPTH_BUFFER_BIT);
+    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
     glLoadIdentity();
     gluLookAt(0, 2, 6,  0, 0, 0,  0, 1, 0);
     glTranslated(x, 0, 0);
     glutSolidSphere(1, 40, 20);
     glutSwapBuffers();
 }
 void idle(void) {
     x += 1.5;
     glutPostRedisplay();
 }
 int main(int argc, char** argv) {
     glutInit(&argc, argv);
     glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
     glutInitWindowSize(160, 120);
     glutCreateWindow("ball");
     glMatrixMode(GL_PROJECTION);
     gluPerspective(45, 4.0 / 3.0, 1, 100);
     glMatrixMode(GL_MODELVIEW);
     glEnable(GL_DEPTH_TEST);
     glEnable(GL_LIGHTING);
     glEnable(GL_LIGHT0);
     glutDisplayFunc(display);
     glutIdleFunc(idle);
     glutMainLoop();
 }
)",
         make_watch<ColorsNotCleared>},
    };
}

}  // namespace twinlight::lint
