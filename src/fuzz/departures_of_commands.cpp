// Departures that show in the order of a scene's commands.
#include <algorithm>
#include <functional>
#include <initializer_list>
#include <set>
#include <utility>
#include <vector>

#include "fuzz/departure_rules.h"

namespace twinlight::fuzz {

namespace {

using Id = CommandId;

bool is_one_of(const Command& command, std::initializer_list<std::string_view> prefixes) {
    return std::ranges::any_of(prefixes, [&](std::string_view prefix) { return command.name().starts_with(prefix); });
}

// Whether a command of the first kind stands anywhere before one of the second.
bool stands_before(const CommandList& scene, std::string_view first, std::string_view second) {
    bool seen = false;
    for (const Command& command : scene.commands) {
        if (seen && command.name().starts_with(second)) return true;
        seen = seen || command.name().starts_with(first);
    }
    return false;
}

// Between a glPushAttrib whose mask has one of `bits`, and none of `without`, and its glPopAttrib.
bool has_inside_push(const CommandList& scene, Enum bits, Enum without,
                     const std::function<bool(const Command&)>& is_it) {
    std::vector<Enum> masks;
    for (const Command& command : scene.commands) {
        if (command.id == Id::glPushAttrib) masks.push_back(command.enumerant(0));
        if (command.id == Id::glPopAttrib && !masks.empty()) masks.pop_back();
        const bool saved =
            std::ranges::any_of(masks, [&](Enum mask) { return (mask & bits) != 0 && (mask & without) == 0; });
        if (saved && is_it(command)) return true;
    }
    return false;
}

bool enables_color_material(const CommandList& scene) {
    return std::ranges::any_of(scene.commands, [](const Command& command) {
        return command.id == Id::glEnable && command.enumerant(0) == kGL_COLOR_MATERIAL;
    });
}

bool lights_two_sides(const CommandList& scene) {
    return std::ranges::any_of(scene.commands, [](const Command& command) {
        return command.name().starts_with("glLightModel") && command.enumerant(0) == kGL_LIGHT_MODEL_TWO_SIDE &&
               command.number(1) != 0;
    });
}

}  // namespace

bool mixes_glcolor3_and_4(const CommandList& scene) { return stands_before(scene, "glColor4", "glColor3"); }

bool mixes_tex_coords(const CommandList& scene) {
    bool seen = false;
    for (const Command& command : scene.commands) {
        if (!command.name().starts_with("glTexCoord")) continue;
        if (command.name()[10] == '4')
            seen = true;
        else if (seen && command.name()[10] != 'P')
            return true;
    }
    return false;
}

bool sets_material_before_pop(const CommandList& scene) {
    return has_inside_push(scene, kGL_LIGHTING_BIT, 0,
                           [](const Command& command) { return command.name().starts_with("glMaterial"); });
}

// The same glShadeModel before and after a glPopAttrib of one list.
bool shades_after_pop_in_list(const CommandList& scene) {
    bool in_list = false, popped = false;
    std::set<Enum> before;
    for (const Command& command : scene.commands) {
        if (command.id == Id::glNewList) {
            in_list = true;
            popped = false;
            before.clear();
        }
        if (command.id == Id::glEndList) in_list = false;
        if (command.id == Id::glPopAttrib) popped = in_list && !before.empty();
        if (command.id != Id::glShadeModel) continue;
        if (popped && before.contains(command.enumerant(0))) return true;
        if (in_list) before.insert(command.enumerant(0));
    }
    return false;
}

bool switches_lights_before_pop(const CommandList& scene) {
    const auto is_light = [](const Command& command) {
        return (command.id == Id::glEnable || command.id == Id::glDisable) && command.enumerant(0) >= kGL_LIGHT0 &&
               command.enumerant(0) < kGL_LIGHT0 + kMaxLights;
    };
    return has_inside_push(scene, kGL_ENABLE_BIT, kGL_LIGHTING_BIT, is_light);
}

bool generates_mipmaps_after_pop(const CommandList& scene) {
    return has_inside_push(scene, kGL_TEXTURE_BIT, 0, [](const Command& command) {
        return command.name().starts_with("glTexParameter") && command.enumerant(1) == kGL_GENERATE_MIPMAP;
    });
}

bool restores_tracked_color(const CommandList& scene) {
    return enables_color_material(scene) && has_inside_push(scene, kGL_CURRENT_BIT, 0, [](const Command& command) {
               return command.name().starts_with("glColor");
           });
}

// The back's material has parameters that vary from vertex to vertex, and they are not the front's: set by glMaterial of one
// side between glBegin and glEnd, or in another way, or the front's are others (2.14.3).
bool sets_sides_apart(const CommandList& scene) {
    if (!lights_two_sides(scene)) return false;
    enum Way { kByMaterial, kByColor };
    std::set<std::pair<Enum, Way>> front, back;
    Enum tracking_face = kGL_FRONT_AND_BACK, tracked = kGL_AMBIENT_AND_DIFFUSE;
    bool inside = false, has_values_of_one_side = false;
    const auto insert = [&](Enum face, Enum pname, Way way) {
        for (const Enum one :
             pname == kGL_AMBIENT_AND_DIFFUSE ? std::vector{kGL_AMBIENT, kGL_DIFFUSE} : std::vector{pname}) {
            if (face != kGL_BACK) front.emplace(one, way);
            if (face != kGL_FRONT) back.emplace(one, way);
        }
    };
    for (const Command& command : scene.commands) {
        if (command.id == Id::glBegin || command.id == Id::glEnd) inside = command.id == Id::glBegin;
        if (command.id == Id::glColorMaterial) {
            tracking_face = command.enumerant(0);
            tracked = command.enumerant(1);
        }
        if (command.id == Id::glEnable && command.enumerant(0) == kGL_COLOR_MATERIAL)
            insert(tracking_face, tracked, kByColor);
        if (!inside || !command.name().starts_with("glMaterial")) continue;
        insert(command.enumerant(0), command.enumerant(1), kByMaterial);
        has_values_of_one_side |= command.enumerant(0) != kGL_FRONT_AND_BACK;
    }
    for (auto* side : {&front, &back}) {  // what tracks the colour is not changed by glMaterial
        for (const auto& [pname, way] : std::set(*side)) {
            if (way == kByColor) side->erase({pname, kByMaterial});
        }
    }
    const auto is_by_material = [](const auto& one) { return one.second == kByMaterial; };
    const bool back_has_any = std::ranges::any_of(back, is_by_material);
    const bool any_material = back_has_any || std::ranges::any_of(front, is_by_material);
    return any_material && !back.empty() && (front != back || (back_has_any && has_values_of_one_side));
}

// A parameter of both sides' material that the first vertex of a glBegin does not have, but a later one.
bool sets_both_sides_after_vertex(const CommandList& scene) {
    if (!lights_two_sides(scene)) return false;
    std::set<Enum> set;
    bool has_vertex = false;
    for (const Command& command : scene.commands) {
        if (command.id == Id::glBegin) {
            set.clear();
            has_vertex = false;
        }
        if (command.name().starts_with("glVertex")) has_vertex = true;
        if (!command.name().starts_with("glMaterial") || command.enumerant(0) != kGL_FRONT_AND_BACK) continue;
        if (!has_vertex)
            set.insert(command.enumerant(1));
        else if (!set.contains(command.enumerant(1)))
            return true;
    }
    return false;
}

bool sets_color_before_new_mode(const CommandList& scene) {
    bool enabled = false, color = false;
    for (const Command& command : scene.commands) {
        if (command.id == Id::glEnable && command.enumerant(0) == kGL_COLOR_MATERIAL) enabled = true;
        if (enabled && is_one_of(command, {"glColor3", "glColor4"})) color = true;
        if (color && command.id == Id::glColorMaterial) return true;
    }
    return false;
}

// A glMaterial, then a glColor that the material follows, then a glNewList before anything is drawn.
bool tracks_color_before_list(const CommandList& scene) {
    bool material = false, color = false;
    for (const Command& command : scene.commands) {
        if (command.name().starts_with("glMaterial")) material = true;
        if (command.id == Id::glEnd) material = color = false;
        color = color || (material && is_one_of(command, {"glColor3", "glColor4"}));
        if (color && command.id == Id::glNewList) return enables_color_material(scene);
    }
    return false;
}

bool lists_edge_flags(const CommandList& scene) {
    bool in_list = false, flags = false, borders = false;
    for (const Command& command : scene.commands) {
        if (command.id == Id::glNewList || command.id == Id::glEndList) in_list = command.id == Id::glNewList;
        flags = flags || (in_list && command.name().starts_with("glEdgeFlag"));
        borders = borders || (command.id == Id::glPolygonMode && command.enumerant(1) != kGL_FILL);
    }
    return flags && borders;
}

// Where it can be seen: by colours that are no linear function, and where one is drawn again, by depths.
bool shows_cut_of_rectangles(const CommandList& scene) {
    bool lit = false;
    int rectangles = 0;
    for (const Command& command : scene.commands) {
        lit = lit || (command.id == Id::glEnable && command.enumerant(0) == kGL_LIGHTING);
        if (command.name().starts_with("glRect")) ++rectangles;
    }
    return rectangles > 1 || (rectangles > 0 && lit);
}

}  // namespace twinlight::fuzz
