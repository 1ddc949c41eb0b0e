// The table of departures, and what of it applies to a scene.
#include "judge/compare/departures.h"

#include <algorithm>

#include "judge/compare/departure_rules.h"

namespace twinlight::compare {

namespace {

constexpr SeenOn kBoth[] = {{"llvmpipe", "Mesa 22.3"}, {"softpipe", "Mesa 22.3"}};
constexpr SeenOn kLlvmpipe[] = {{"llvmpipe", "Mesa 22.3"}};
constexpr SeenOn kSoftpipe[] = {{"softpipe", "Mesa 22.3"}};

}  // namespace

const std::vector<Departure>& departures() {
    static const std::vector<Departure> list = {
        // What shaders share comes first: where one of these applies, the others do not matter.
        {.name = "no answer in the text",
         .section = "2.1.1, 2.11.3, 2.14.1: singular matrices, directions of length 0, a vertex without a place, a "
                    "light at it",
         .leaves = Leaves::kOpen,
         .of_vertex = has_no_answer},
        {.name = "light at the horizon of a vertex",
         .section = "2.14.1: f_i jumps at n.VP = 0, and rounding decides",
         .leaves = Leaves::kOpen,
         .of_vertex = has_light_at_horizon},
        {.name = "a vertex on the edge of a spot's cone",
         .section = "2.14.1: lit where the angle is the cutoff: on the axis of a cone of 0, at 90 degrees in one of 90",
         .seen_on = kBoth,
         .of_vertex = is_at_exact_edge_of_cone},
        {.name = "vertex near the edge of a spot's cone",
         .section = "2.14.1: spot_i jumps at the cutoff, and rounding decides",
         .leaves = Leaves::kOpen,
         .of_vertex = is_near_edge_of_cone},
        {.name = "texture coordinates whose q is 0",
         .section = "3.8.7: s/q and t/q have no value",
         .leaves = Leaves::kOpen,
         .of_vertex = has_no_q},
        {.name = "clipped polygons as lines and points",
         .section = "2.12, 3.5.4",
         .leaves = Leaves::kDriver,
         .seen_on = kBoth,
         .of_draw = draws_borders_of_clipped_polygons},
        {.name = "edge flags of strips and fans",
         .section = "2.6.2",
         .leaves = Leaves::kDriver,
         .seen_on = kBoth,
         .of_draw = has_edge_flags_in_strip},
        {.name = "polygon offset of borders without area",
         .section = "3.5.5: m is a slope, which these polygons do not have",
         .leaves = Leaves::kOpen,
         .of_draw = offsets_borders_without_area},
        {.name = "polygon offset of borders that leaves the depth range",
         .section = "3.5.5: fragments' depths are offset and clamped; the driver clamps those of corners",
         .leaves = Leaves::kDriver,
         .seen_on = kBoth,
         .of_draw = offsets_borders_out_of_range},
        {.name = "polygon offset of lines or points alone",
         .section = "3.5.5: filled polygons have an offset where GL_POLYGON_OFFSET_FILL is enabled",
         .leaves = Leaves::kDriver,
         .seen_on = kLlvmpipe,
         .of_draw = offsets_other_modes_alone},
        {.name = "polygon offset of one of two polygon modes",
         .section = "3.5.5",
         .leaves = Leaves::kDriver,
         .seen_on = kBoth,
         .of_draw = offsets_one_of_two_modes},
        {.name = "level of detail of points",
         .section = "3.8.8",
         .leaves = Leaves::kDriver,
         .seen_on = kBoth,
         .of_draw = biases_level_of_points},
        {.name = "faces of borders in softpipe's shaders",
         .section = "GLSL 1.20, 7.2: gl_FrontFacing is that of the primitive; docs/architecture.md",
         .leaves = Leaves::kDriver,
         .seen_on = kSoftpipe,
         .of_draw = has_faces_on_borders},
        {.name = "wide lines in softpipe",
         .section = "3.4.2: a wide line ends where the thin one does; softpipe's is half a pixel further along",
         .leaves = Leaves::kDriver,
         .seen_on = kSoftpipe,
         .of_draw = has_wide_lines},
        {.name = "wide points in softpipe",
         .section = "3.3: a square of a whole number of pixels about a corner or a centre; softpipe's is as it falls",
         .leaves = Leaves::kDriver,
         .seen_on = kSoftpipe,
         .of_draw = has_wide_points},
        {.name = "level of detail in softpipe",
         .section = "3.8.8: rho may be as small as the larger of m_u and m_v; the reference allows less",
         .leaves = Leaves::kOpen,
         .seen_on = kSoftpipe,
         .of_draw = has_level_of_detail},
        {.name = "the colour sum in fog",
         .section = "3.9, 3.10",
         .seen_on = kBoth,
         .of_draw = adds_secondary_color_in_fog},
        {.name = "GL_CLAMP between a nearest and a linear filter",
         .section = "3.8.7, 3.8.8",
         .leaves = Leaves::kDriver,
         .seen_on = kLlvmpipe,
         .of_draw = clamps_between_nearest_and_linear},
        {.name = "shininess 0 with attenuation or a spot",
         .section = "2.14.1: a factor of 1; the driver gives (n.VP)^(n.VP)",
         .seen_on = kBoth,
         .of_draw = has_shininess_0_with_factors},
        {.name = "shininess 0 on one side of two",
         .section = "2.14.1: a factor of 1 on that side whatever the other has",
         .seen_on = kLlvmpipe,
         .of_draw = has_shininess_0_on_one_side},
        {.name = "colour material before the first glColor",
         .section = "2.14.3: the material follows the current colour from glEnable on",
         .seen_on = kBoth,
         .of_vertex = has_color_material_of_no_color},
        {.name = "glMaterial, a tracked glColor, glNewList",
         .section = "2.14.3: the material follows the colour",
         .seen_on = kBoth,
         .of_commands = tracks_color_before_list},
        {.name = "colour material on the back alone of two sides",
         .section =
             "2.14.3: all channels of the back's material follow; the driver's program multiplies the red one only",
         .seen_on = kBoth,
         .of_draw = has_color_material_on_back_alone},
        {.name = "materials of vertices that two sides do not share",
         .section = "2.14.2: glMaterial between glBegin and glEnd changes all channels of the side that it names",
         .seen_on = kBoth,
         .of_commands = sets_sides_apart},
        {.name = "glMaterial of two sides after a vertex",
         .section = "2.6, 2.14.2: the vertices before it in the same glBegin have the material that each side had",
         .seen_on = kBoth,
         .of_commands = sets_both_sides_after_vertex},
        {.name = "glColor before a new glColorMaterial",
         .section = "2.14.3",
         .seen_on = kBoth,
         .of_commands = sets_color_before_new_mode},
        {.name = "colour material after glPopAttrib",
         .section = "2.14.3",
         .seen_on = kBoth,
         .of_commands = restores_tracked_color},
        {.name = "glColor3 after glColor4", .section = "2.7", .seen_on = kBoth, .of_commands = mixes_glcolor3_and_4},
        {.name = "glTexCoord1 to 3 after glTexCoord4",
         .section = "2.7",
         .seen_on = kBoth,
         .of_commands = mixes_tex_coords},
        {.name = "glMaterial right before glPopAttrib",
         .section = "6.1.14",
         .seen_on = kBoth,
         .of_commands = sets_material_before_pop},
        {.name = "edge flags in a display list",
         .section = "5.4, 2.6.2: a list draws what its commands draw",
         .seen_on = kBoth,
         .of_commands = lists_edge_flags},
        {.name = "glRect as a quadrilateral",
         .section = "2.10: glRect is a GL_POLYGON",
         .seen_on = kBoth,
         .of_commands = shows_cut_of_rectangles},
        {.name = "glShadeModel after glPopAttrib in a display list",
         .section = "5.4: a list holds every command that may be compiled",
         .seen_on = kBoth,
         .of_commands = shades_after_pop_in_list},
        {.name = "lights after glPopAttrib of GL_ENABLE_BIT",
         .section = "6.2, table 6.10",
         .seen_on = kBoth,
         .of_commands = switches_lights_before_pop},
        {.name = "GL_GENERATE_MIPMAP after glPopAttrib",
         .section = "6.2, table 6.17",
         .seen_on = kBoth,
         .of_commands = generates_mipmaps_after_pop},
        {.name = "a vertex whose w is not 1 under a positional light",
         .section = "2.14.1: P1P2 is homogeneous",
         .seen_on = kBoth,
         .of_vertex = has_w_under_positional_light},
        {.name = "fog of a vertex whose w is not 1", .section = "3.10", .seen_on = kBoth, .of_draw = has_w_in_fog},
        {.name = "a direction whose square leaves the floats",
         .section = "2.14.1, 2.1.1: positions and normals up to 2^32 are representable, and unit vectors have length 1",
         .seen_on = kBoth,
         .of_vertex = has_extreme_direction},
        {.name = "rescaling under a great scale", .section = "2.11.3", .seen_on = kBoth, .of_draw = rescales_much},
    };
    return list;
}

namespace {

// Of those that ask for commands, which apply: in the order of the list, a bool each.
class OfCommands {
  public:
    OfCommands() {
        for (const Departure& departure : departures())
            if (departure.of_commands) rules_.push_back({&departure, departure.of_commands(), false});
    }

    void see(const Command& command) {
        for (Rule& rule : rules_) rule.applies = rule.see(command);
    }
    bool apply(const Departure& departure) const {
        return std::ranges::any_of(rules_,
                                   [&](const Rule& rule) { return rule.departure == &departure && rule.applies; });
    }

  private:
    struct Rule {
        const Departure* departure;
        CommandRule see;
        bool applies;
    };
    std::vector<Rule> rules_;
};

bool applies_in(const Departure& departure, const Frame& frame) {
    return std::ranges::any_of(frame.draws(), [&](const Draw* draw) {
        if (departure.of_draw) return departure.of_draw(*draw);
        return std::ranges::any_of(draw->vertices,
                                   [&](const Vertex& vertex) { return departure.of_vertex(*draw, vertex); });
    });
}

}  // namespace

bool Departure::is_known_on(const Driver& driver) const {
    return std::ranges::any_of(
        seen_on, [&](const SeenOn& seen) { return seen.driver == driver.name && driver.has_version(seen.version); });
}

// What several drivers show, any may: they share parts of Mesa.
bool Departure::may_show_on(const Driver& driver) const {
    const auto is_other = [&](const SeenOn& seen) { return seen.driver != seen_on.front().driver; };
    return seen_on.empty() || std::ranges::any_of(seen_on, is_other) || seen_on.front().driver == driver.name;
}

bool is_listed(const Driver& driver) {
    return std::ranges::any_of(departures(), [&](const Departure& departure) { return departure.is_known_on(driver); });
}

std::vector<const Departure*> known_departures_in(const Scene& scene, const Driver& driver) {
    OfCommands of_commands;
    scene.recording->for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kCommand) of_commands.see(step.command);
        return true;
    });
    std::vector<const Departure*> found;
    for (const Departure& departure : departures()) {
        if (departure.leaves == Leaves::kOpen || !departure.is_known_on(driver)) continue;
        if (departure.of_commands ? of_commands.apply(departure) : applies_in(departure, scene.frame))
            found.push_back(&departure);
    }
    return found;
}

DeparturesOfScene::DeparturesOfScene(const CommandList& scene, const Driver& driver,
                                     const std::vector<std::string_view>& lifted) {
    OfCommands of_commands;
    for (const Command& command : scene.commands) of_commands.see(command);
    for (const Departure& departure : departures()) {
        if (!departure.may_show_on(driver) || std::ranges::find(lifted, departure.name) != lifted.end()) continue;
        if (departure.of_draw || departure.of_vertex) asked_.push_back(&departure);
        if (!of_all_ && of_commands.apply(departure)) of_all_ = &departure;
    }
}

const Departure* DeparturesOfScene::find(const std::function<bool(const Departure&)>& applies) const {
    const Departure* found = of_all_;
    for (const Departure* departure : asked_) {
        if (found && departure->leaves == Leaves::kFixedFunction) continue;
        if (applies(*departure)) {
            if (departure->leaves != Leaves::kFixedFunction) return departure;
            found = departure;
        }
    }
    return found;
}

const Departure* DeparturesOfScene::at(const Draw& draw, const Vertex& vertex) const {
    return find([&](const Departure& departure) {
        return departure.of_draw ? departure.of_draw(draw) : departure.of_vertex(draw, vertex);
    });
}

const Departure* DeparturesOfScene::in(const Frame& frame) const {
    return find([&](const Departure& departure) { return applies_in(departure, frame); });
}

}  // namespace twinlight::compare
