#include "render/fixed/fixed.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/effect/scrubbed_state.h"
#include "render/fixed/prepared_frame.h"

namespace twinlight::fixed {

namespace {

// Black and depth 1, whatever the state says of clearing: it is as it was afterwards.
void clear_to_black() {
    GLint list = 0, mask = GL_TRUE;
    glGetIntegerv(GL_LIST_INDEX, &list);
    if (list != 0) return;  // a list is being compiled: the clearing would become a part of it
    std::array<GLfloat, 4> color{};
    std::array<GLboolean, 4> color_mask{};
    GLdouble depth = 1;
    glGetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
    glGetBooleanv(GL_COLOR_WRITEMASK, color_mask.data());
    glGetDoublev(GL_DEPTH_CLEAR_VALUE, &depth);
    glGetIntegerv(GL_DEPTH_WRITEMASK, &mask);
    const bool scissor = glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;

    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClearColor(0, 0, 0, 0);
    glClearDepth(1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    if (scissor) glEnable(GL_SCISSOR_TEST);
    glColorMask(color_mask[0], color_mask[1], color_mask[2], color_mask[3]);
    glDepthMask(static_cast<GLboolean>(mask));
    glClearColor(color[0], color[1], color[2], color[3]);
    glClearDepth(depth);
}

// Whether the Frame has all that its commands say: what is beyond the eight lights it has.
bool is_whole(const Frame& frame) {
    return std::ranges::none_of(frame.unsupported, [](const Unsupported& what) {
        return std::ranges::find(what.renderers, "programmable") != what.renderers.end();
    });
}

bool has_lights_beyond(const Frame& frame) {
    return is_whole(frame) && std::ranges::any_of(frame.items, [](const auto& item) {
               const Draw* draw = std::get_if<Draw>(&item);
               return draw && draw->lighting.enabled && draw->lighting.lights.size() > kMaxLights;
           });
}

void draw_commands(const Frame& frame, const RenderOptions& options) {
    check_shading(options);
    Driver driver(frame.width, frame.height);
    driver.make_empty_lists(frame.lists_called_before_made);
    clear_to_black();
    if (options.shading) glShadeModel(*options.shading == Shading::kFlat ? GL_FLAT : GL_SMOOTH);
    frame.commands->for_each([&](const Step& step) {
        switch (step.kind) {
            case Step::Kind::kCommand:
                if (!options.shading || step.command.id != CommandId::glShadeModel) driver.execute(step.command);
                break;
            case Step::Kind::kFrameEnd: clear_to_black(); break;
            case Step::Kind::kOutside:
            case Step::Kind::kCutOff: break;
        }
        return true;
    });
    glFinish();
}

void draw_scrubbed(const Frame& frame, const RenderOptions& options) {
    PreparedFrame(frame, options, Scrub::kState).draw();
    glFinish();
}

}  // namespace

void draw(const Frame& frame, const RenderOptions& options) {
    if (has_lights_beyond(frame))
        draw_scrubbed(frame, options);
    else
        draw_commands(frame, options);
}

void check_shading(const RenderOptions& options) {
    if (options.shading == Shading::kPhong)
        throw std::invalid_argument("the fixed function has no phong shading; use --with programmable or reference");
    if (options.shading == Shading::kExact)
        throw std::invalid_argument(
            "the fixed function draws meshes, no exact surfaces; use --with programmable or reference");
}

Image render(const Frame& frame, const RenderOptions& options) {
    draw(frame, options);
    return read_pixels(frame.width, frame.height);
}

Image render_scrubbed(const Frame& frame, const RenderOptions& options) {
    if (is_whole(frame))
        draw_scrubbed(frame, options);
    else
        draw_commands(frame, options);
    return read_pixels(frame.width, frame.height);
}

void note_lights_beyond(Frame& frame, const RenderOptions& options) {
    RenderOptions of_gl = options;
    of_gl.lecture_variants = false;
    Unsupported beyond{.name = "", .count = 0, .first = {}, .renderers = {"fixed"}};
    double bound = 0;
    for (const auto& item : frame.items) {
        const Draw* draw = std::get_if<Draw>(&item);
        if (!draw || draw->lighting.lights.size() <= kMaxLights) continue;
        const Plan plan = plan_effects(*draw, of_gl);
        const ScrubbedState state = scrubbed_state(plan, kMaxLights);
        if (state.lights_beyond.empty() || plan.error_bound + state.bound_beyond <= plan.budget) continue;
        if (beyond.count++ == 0) beyond.first = draw->place;
        bound = std::max(bound, plan.error_bound + state.bound_beyond);
    }
    if (beyond.count == 0) return;
    beyond.name = fmt::format("more than eight lights: those beyond, up to {:.3g} of a channel,", bound);
    frame.unsupported.push_back(std::move(beyond));
}

}  // namespace twinlight::fixed
