// Departures that depend on the order of a scene's commands. A rule sees the commands one after the other and keeps little state,
// because a recording may be larger than memory.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "judge/compare/departure_rules.h"
#include "scene/state/attributes.h"
#include "scene/state/pixel_unpacking.h"

namespace twinlight::compare {

namespace {

using Id = CommandId;

bool is_one_of(const Command& command, std::initializer_list<std::string_view> prefixes) {
    return std::ranges::any_of(prefixes, [&](std::string_view prefix) { return command.name().starts_with(prefix); });
}

bool lights_two_sides(const Command& command) {
    return command.name().starts_with("glLightModel") && command.enumerant(0) == kGL_LIGHT_MODEL_TWO_SIDE &&
           command.number(1) != 0;
}

// For glMaterial; other parameters are errors and change nothing.
bool is_material_parameter(Enum pname) {
    return pname == kGL_AMBIENT || pname == kGL_DIFFUSE || pname == kGL_SPECULAR || pname == kGL_EMISSION ||
           pname == kGL_SHININESS || pname == kGL_AMBIENT_AND_DIFFUSE || pname == kGL_COLOR_INDEXES;
}

// Any command for which `shows` is true.
template <typename Shows>
CommandRule any_command(Shows shows) {
    return [shows, found = false](const Command& command) mutable { return found = shows(command) || found; };
}

// Both rules, at any two places of the scene.
CommandRule both(CommandRule first, CommandRule second) {
    return [first = std::move(first), second = std::move(second)](const Command& command) {
        const bool a = first(command), b = second(command);
        return a && b;
    };
}

// A command for which `is_it` is true, inside a glPushAttrib whose mask has one of `bits` and none of `without`.
template <typename IsIt>
CommandRule inside_push(Enum bits, Enum without, IsIt is_it) {
    return any_command([=, masks = std::vector<Enum>()](const Command& command) mutable {
        if (command.id == Id::glPushAttrib && masks.size() < kAttributeStackDepth)
            masks.push_back(command.enumerant(0));
        if (command.id == Id::glPopAttrib && !masks.empty()) masks.pop_back();
        const bool saved =
            std::ranges::any_of(masks, [&](Enum mask) { return (mask & bits) != 0 && (mask & without) == 0; });
        return saved && is_it(command);
    });
}

// The material parameters that vary from vertex to vertex: by side, and by the command that changes them (2.14.2, 2.14.3).
class VaryingMaterials {
  public:
    void see(const Command& command) {
        if (command.id == Id::glBegin || command.id == Id::glEnd) inside_ = command.id == Id::glBegin;
        if (command.id == Id::glColorMaterial) {
            tracking_face_ = command.enumerant(0);
            tracked_ = command.enumerant(1);
        }
        if (enables_color_material(command)) insert(tracking_face_, tracked_, kByColor);
        if (!inside_ || !command.name().starts_with("glMaterial")) return;
        has_values_of_one_side_ |= command.enumerant(0) != kGL_FRONT_AND_BACK;
        insert(command.enumerant(0), command.enumerant(1), kByMaterial);
    }

    // Whether the back has such parameters and they differ from the front's: others, changed by another command, or set by a
    // glMaterial of one side only.
    bool has_sides_apart() const { return apart_; }

  private:
    enum Way { kByMaterial, kByColor };
    using Parameters = std::set<std::pair<Enum, Way>>;

    void insert(Enum face, Enum pname, Way way) {
        if (!is_material_parameter(pname)) return;
        if (pname == kGL_AMBIENT_AND_DIFFUSE) {
            insert(face, kGL_AMBIENT, way);
            return insert(face, kGL_DIFFUSE, way);
        }
        if (face != kGL_BACK) front_.emplace(pname, way);
        if (face != kGL_FRONT) back_.emplace(pname, way);
        apart_ = are_apart(without_tracked(front_), without_tracked(back_));
    }
    // glMaterial does not change parameters that follow the colour.
    static Parameters without_tracked(const Parameters& side) {
        Parameters left = side;
        for (const auto& [pname, way] : side)
            if (way == kByColor) left.erase({pname, kByMaterial});
        return left;
    }
    bool are_apart(const Parameters& front, const Parameters& back) const {
        const auto is_by_material = [](const auto& one) { return one.second == kByMaterial; };
        const bool back_has_any = std::ranges::any_of(back, is_by_material);
        const bool any_material = back_has_any || std::ranges::any_of(front, is_by_material);
        return any_material && !back.empty() && (front != back || (back_has_any && has_values_of_one_side_));
    }

    Parameters front_, back_;
    Enum tracking_face_ = kGL_FRONT_AND_BACK, tracked_ = kGL_AMBIENT_AND_DIFFUSE;
    bool inside_ = false, has_values_of_one_side_ = false, apart_ = false;
};

// Values that a driver may keep aside until something is drawn or asked for, or until glPushAttrib saves them.
class KeptValues {
  public:
    static bool uses(const Command& command) {
        return command.id == Id::glEnd || command.sig().family == Family::kShape ||
               command.sig().family == Family::kQuadric ||
               is_one_of(command, {"glDraw", "glCallList", "glRect", "glEvalMesh", "glGetMaterial"});
    }
    void see(const Command& command) {
        const Enum pushed = command.id == Id::glPushAttrib ? command.enumerant(0) : 0;
        if (uses(command) || (pushed & kGL_LIGHTING_BIT) != 0) has_material_ = false;
        if (uses(command) || (pushed & kGL_CURRENT_BIT) != 0) has_current_ = false;
        if (command.name().starts_with("glMaterial")) has_material_ = true;
        const bool is_current = is_one_of(command, {"glColor3", "glColor4", "glNormal3", "glTexCoord",
                                                    "glMultiTexCoord", "glSecondaryColor3", "glFogCoord"});
        if (is_current && !command.name().ends_with("Pointer")) has_current_ = true;
    }
    bool has_material() const { return has_material_; }
    bool has_current() const { return has_current_; }

  private:
    bool has_material_ = false, has_current_ = false;
};

}  // namespace

bool enables_color_material(const Command& command) {
    return command.id == Id::glEnable && command.enumerant(0) == kGL_COLOR_MATERIAL;
}

bool draws_other_than_points(const Command& command) {
    const bool has_mode = is_one_of(command, {"glBegin", "glDraw"}) && command.id != Id::glDrawBuffer;
    if (has_mode) return command.enumerant(0) != kGL_POINTS;
    return command.sig().family == Family::kShape ||
           is_one_of(command, {"glRect", "glEvalMesh", "glBitmap", "glDrawPixels", "glCopyPixels", "glCallList", "mesh",
                               "shape"});
}

CommandRule mixes_glcolor3_and_4() {
    return any_command([has_4 = false](const Command& command) mutable {
        has_4 = has_4 || command.name().starts_with("glColor4");
        return has_4 && command.name().starts_with("glColor3");
    });
}

CommandRule mixes_tex_coords() {
    return any_command([has_4 = false](const Command& command) mutable {
        if (!command.name().starts_with("glTexCoord")) return false;
        const char form = command.name()[10];  // glTexCoord2f: 2; glTexCoordPointer: P
        has_4 = has_4 || form == '4';
        return has_4 && form != '4' && form != 'P';
    });
}

namespace {

// A value of this group set right before the glPopAttrib that restores it.
CommandRule sets_before_pop(Enum group, bool (KeptValues::*is_set)() const) {
    return any_command([=, kept = KeptValues(), masks = std::vector<Enum>()](const Command& command) mutable {
        kept.see(command);
        if (command.id == Id::glPushAttrib && masks.size() < kAttributeStackDepth)
            masks.push_back(command.enumerant(0));
        if (command.id != Id::glPopAttrib || masks.empty()) return false;
        const Enum mask = masks.back();
        masks.pop_back();
        return (mask & group) != 0 && (kept.*is_set)();
    });
}

}  // namespace

CommandRule sets_material_before_pop() { return sets_before_pop(kGL_LIGHTING_BIT, &KeptValues::has_material); }
CommandRule sets_color_before_pop() { return sets_before_pop(kGL_CURRENT_BIT, &KeptValues::has_current); }

// glMaterial, then glEnable(GL_COLOR_MATERIAL) before anything is drawn, and no glColor while it is enabled.
CommandRule sets_material_before_tracking() {
    return any_command([kept = KeptValues(), is_early = false](const Command& command) mutable {
        kept.see(command);
        if (enables_color_material(command)) is_early = is_early || kept.has_material();
        if (is_one_of(command, {"glColor3", "glColor4"})) is_early = false;
        const bool ends = (command.id == Id::glDisable && command.enumerant(0) == kGL_COLOR_MATERIAL) ||
                          command.id == Id::glColorMaterial || command.id == Id::glPopAttrib;
        return is_early && (ends || command.name().starts_with("glVertex") || KeptValues::uses(command));
    });
}

// The same glShadeModel before and after a glPopAttrib in one list.
CommandRule shades_after_pop_in_list() {
    struct InList {
        bool in_list = false, popped = false;
        bool before_flat = false, before_smooth = false;
    };
    return any_command([list = InList()](const Command& command) mutable {
        if (command.id == Id::glNewList) list = {.in_list = true};
        if (command.id == Id::glEndList) list.in_list = false;
        if (command.id == Id::glPopAttrib) list.popped = list.in_list && (list.before_flat || list.before_smooth);
        if (command.id != Id::glShadeModel) return false;
        bool& before = command.enumerant(0) == kGL_FLAT ? list.before_flat : list.before_smooth;
        const bool again = list.popped && before;
        before = before || list.in_list;
        return again;
    });
}

CommandRule switches_lights_before_pop() {
    return inside_push(kGL_ENABLE_BIT, kGL_LIGHTING_BIT, [](const Command& command) {
        return (command.id == Id::glEnable || command.id == Id::glDisable) && command.enumerant(0) >= kGL_LIGHT0 &&
               command.enumerant(0) < kGL_LIGHT0 + kMaxLights;
    });
}

CommandRule generates_mipmaps_after_pop() {
    return inside_push(kGL_TEXTURE_BIT, 0, [](const Command& command) {
        return command.name().starts_with("glTexParameter") && command.enumerant(1) == kGL_GENERATE_MIPMAP;
    });
}

// Depths that glCopyTexImage copies after GL_DEPTH_TEXTURE_MODE was set.
CommandRule copies_depths_after_mode() {
    return any_command([has_mode = false](const Command& command) mutable {
        if (command.name().starts_with("glTexParameter") && command.enumerant(1) == kGL_DEPTH_TEXTURE_MODE)
            has_mode = has_mode || command.enumerant(2) != kGL_LUMINANCE;
        const bool copies = command.id == Id::glCopyTexImage1D || command.id == Id::glCopyTexImage2D;
        const auto format = copies ? internal_format(command.enumerant(2)) : std::nullopt;
        return has_mode && format && format->base_format == kGL_DEPTH_COMPONENT;
    });
}

CommandRule restores_tracked_color() {
    return both(any_command(enables_color_material), inside_push(kGL_CURRENT_BIT, 0, [](const Command& command) {
                    return command.name().starts_with("glColor");
                }));
}

CommandRule sets_sides_apart() {
    return both(any_command(lights_two_sides), [materials = VaryingMaterials()](const Command& command) mutable {
        materials.see(command);
        return materials.has_sides_apart();
    });
}

// A glMaterial of both sides that comes after the first vertex of a glBegin, of a parameter not set before that vertex.
CommandRule sets_both_sides_after_vertex() {
    return both(any_command(lights_two_sides),
                any_command([set = std::set<Enum>(), has_vertex = false](const Command& command) mutable {
                    if (command.id == Id::glBegin) {
                        set.clear();
                        has_vertex = false;
                    }
                    if (command.name().starts_with("glVertex")) {
                        has_vertex = true;
                        return false;
                    }
                    if (!command.name().starts_with("glMaterial") || command.enumerant(0) != kGL_FRONT_AND_BACK ||
                        !is_material_parameter(command.enumerant(1)))
                        return false;
                    if (!has_vertex) set.insert(command.enumerant(1));
                    return !set.contains(command.enumerant(1));
                }));
}

CommandRule sets_color_before_new_mode() {
    return any_command([enabled = false, color = false](const Command& command) mutable {
        enabled = enabled || enables_color_material(command);
        color = color || (enabled && is_one_of(command, {"glColor3", "glColor4"}));
        return color && command.id == Id::glColorMaterial;
    });
}

// A glMaterial, then a glColor that the material follows, then a glNewList before anything is drawn.
CommandRule tracks_color_before_list() {
    return both(any_command(enables_color_material),
                any_command([material = false, color = false](const Command& command) mutable {
                    if (command.name().starts_with("glMaterial")) material = true;
                    if (command.id == Id::glEnd) material = color = false;
                    color = color || (material && is_one_of(command, {"glColor3", "glColor4"}));
                    return color && command.id == Id::glNewList;
                }));
}

CommandRule lists_edge_flags() {
    return both(any_command([in_list = false](const Command& command) mutable {
                    if (command.id == Id::glNewList || command.id == Id::glEndList)
                        in_list = command.id == Id::glNewList;
                    return in_list && command.name().starts_with("glEdgeFlag");
                }),
                any_command([](const Command& command) {
                    return command.id == Id::glPolygonMode && command.enumerant(1) != kGL_FILL;
                }));
}

// Where the cut is visible: with lighting and with coordinates generated from directions, which are not linear; and with several
// rectangles, by their depths.
CommandRule shows_cut_of_rectangles() {
    return [curved = false, rectangles = 0](const Command& command) mutable {
        curved = curved || (command.id == Id::glEnable && command.enumerant(0) == kGL_LIGHTING) ||
                 (command.name().starts_with("glTexGen") && command.enumerant(1) == kGL_TEXTURE_GEN_MODE &&
                  (command.enumerant(2) == kGL_SPHERE_MAP || command.enumerant(2) == kGL_REFLECTION_MAP));
        if (rectangles < 2 && command.name().starts_with("glRect")) ++rectangles;
        return rectangles > 1 || (rectangles > 0 && curved);
    };
}

// Other primitives than points, while glTexEnv(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE) counts for points.
CommandRule draws_others_beside_sprites() {
    return [has_sprites = false, had_sprites = false, replaces = false, found = false](const Command& command) mutable {
        const bool switches = command.id == Id::glEnable || command.id == Id::glDisable;
        if (switches && command.enumerant(0) == kGL_POINT_SPRITE) has_sprites = command.id == Id::glEnable;
        had_sprites = had_sprites || has_sprites;
        if (command.id == Id::glPopAttrib) has_sprites = had_sprites;
        if (command.name().starts_with("glTexEnv") && command.enumerant(1) == kGL_COORD_REPLACE)
            replaces = replaces || (command.arguments.size() > 2 && command.number(2) != 0);
        return found = found || (draws_other_than_points(command) && has_sprites && replaces);
    };
}

CommandRule maps_drawn_pixels() {
    return both(any_command([](const Command& command) {
                    return command.name().starts_with("glPixelTransfer") && command.enumerant(0) == kGL_MAP_COLOR &&
                           command.number(1) != 0;
                }),
                any_command([](const Command& command) {
                    return command.id == Id::glDrawPixels || command.id == Id::glCopyPixels;
                }));
}

// The driver draws a pixel rectangle as a polygon, which shows its back if one axis is mirrored.
CommandRule mirrors_stenciled_pixels() {
    const auto has_back = [](const Command& command) {
        return command.name().starts_with("glStencil") && command.name().ends_with("Separate");
    };
    const auto mirrors = [](const Command& command) {
        return command.id == Id::glPixelZoom && command.number(0) * command.number(1) < 0;
    };
    const auto draws = [](const Command& command) {
        return command.id == Id::glDrawPixels || command.id == Id::glCopyPixels;
    };
    return both(both(any_command(has_back), any_command(mirrors)), any_command(draws));
}

CommandRule transfers_stencil_values() {
    return both(any_command([](const Command& command) {
                    return command.name().starts_with("glPixelTransfer") &&
                           (command.enumerant(0) == kGL_MAP_STENCIL || command.enumerant(0) == kGL_INDEX_SHIFT ||
                            command.enumerant(0) == kGL_INDEX_OFFSET) &&
                           command.number(1) != 0;
                }),
                any_command([](const Command& command) {
                    return (command.id == Id::glDrawPixels && command.enumerant(2) == kGL_STENCIL_INDEX) ||
                           (command.id == Id::glCopyPixels &&
                            (command.enumerant(4) == kGL_STENCIL || command.enumerant(4) == kGL_DEPTH_STENCIL));
                }));
}

CommandRule shades_evaluated_meshes_flat() {
    return both(any_command([](const Command& command) {
                    return (command.id == Id::glShadeModel && command.enumerant(0) == kGL_FLAT) ||
                           (command.id == Id::glPolygonMode && command.enumerant(1) != kGL_FILL);
                }),
                any_command([](const Command& command) {
                    return command.id == Id::glEvalMesh2 && command.enumerant(0) == kGL_FILL;
                }));
}

// Two targets in one unit, and the one of the higher dimension has no image.
CommandRule enables_incomplete_texture() {
    static constexpr std::array kTargets{kGL_TEXTURE_1D, kGL_TEXTURE_2D, kGL_TEXTURE_3D, kGL_TEXTURE_CUBE_MAP};
    return any_command([unit = kGL_TEXTURE0, enabled = std::map<Enum, std::set<std::size_t>>(),
                        has_image = std::array<bool, 4>()](const Command& command) mutable {
        if (command.id == Id::glActiveTexture) unit = command.enumerant(0);
        if (is_one_of(command, {"glTexImage", "glCopyTexImage", "gluBuild"})) {
            const Enum image = command.enumerant(0);
            const bool is_face =
                image >= kGL_TEXTURE_CUBE_MAP_POSITIVE_X && image < kGL_TEXTURE_CUBE_MAP_POSITIVE_X + 6;
            const auto of = std::ranges::find(kTargets, is_face ? kGL_TEXTURE_CUBE_MAP : image);
            if (of != kTargets.end()) has_image[static_cast<std::size_t>(of - kTargets.begin())] = true;
        }
        if (command.id != Id::glEnable && command.id != Id::glDisable) return false;
        const auto target = std::ranges::find(kTargets, command.enumerant(0));
        if (target == kTargets.end()) return false;
        std::set<std::size_t>& dimensions = enabled[unit];
        const auto dimension = static_cast<std::size_t>(target - kTargets.begin());
        if (command.id == Id::glEnable)
            dimensions.insert(dimension);
        else
            dimensions.erase(dimension);
        return dimensions.size() > 1 && !has_image[*dimensions.rbegin()];
    });
}

CommandRule sets_base_above_greatest_level() {
    return any_command([least = 1000.0, base = 0.0](const Command& command) mutable {
        if (!command.name().starts_with("glTexParameter")) return false;
        if (command.enumerant(1) == kGL_TEXTURE_MAX_LEVEL) least = std::min(least, command.number(2));
        if (command.enumerant(1) == kGL_TEXTURE_BASE_LEVEL) base = std::max(base, command.number(2));
        return base > least;
    });
}

// Once something was drawn, the driver knows the texture's new images.
CommandRule makes_mipmaps_before_object_draws() {
    return any_command([is_bound = false, has_drawn = false, is_in_list = false](const Command& command) mutable {
        if (command.id == Id::glNewList || command.id == Id::glEndList) is_in_list = command.id == Id::glNewList;
        if (command.id == Id::glBindFramebuffer) is_bound = command.number(1) != 0;
        if (is_one_of(command, {"glBindFramebuffer", "glFramebufferTexture"})) has_drawn = false;
        if (!is_in_list && (command.id == Id::glEnd || command.id == Id::glClear)) has_drawn = true;
        return command.id == Id::glGenerateMipmap && is_bound && !has_drawn;
    });
}

namespace {

// Finds attributes that are given for the first time since glBegin, after a vertex. Each side's parameter of a material is one.
class LateAttributes {
  public:
    static bool is_vertex(const Command& command) {
        return is_one_of(command, {"glVertex", "glArrayElement", "glEval"});
    }
    // Whether the command gives an attribute.
    static bool gives(const Command& command) { return !kind_of(command).empty(); }

    // Whether it gives one for the first time, after a vertex.
    bool operator()(const Command& command) {
        if (command.id == Id::glNewList || command.id == Id::glEndList) is_in_list = command.id == Id::glNewList;
        if (command.id == Id::glBegin) {
            mode = command.enumerant(0);
            vertices = late = 0;
            given_.clear();
        }
        if (command.id == Id::glEnd) mode.reset();
        if (!mode) return false;
        if (is_vertex(command)) ++vertices;
        const std::string kind = kind_of(command);
        if (kind.empty() || !given_.insert(kind).second || vertices == 0) return false;
        ++late;
        return true;
    }

    bool is_in_list = false;
    std::optional<Enum> mode{};  // between glBegin and glEnd
    int vertices = 0, late = 0;  // since glBegin

  private:
    // "glMaterial1032 4608"; empty for other commands.
    static std::string kind_of(const Command& command) {
        static constexpr std::array<std::string_view, 8> kKinds{"glColor",    "glSecondaryColor", "glNormal",
                                                                "glTexCoord", "glMultiTexCoord",  "glFogCoord",
                                                                "glEdgeFlag", "glMaterial"};
        const auto found =
            std::ranges::find_if(kKinds, [&](std::string_view prefix) { return command.name().starts_with(prefix); });
        if (found == kKinds.end() || command.name().starts_with("glColorM")) return "";
        std::string kind(*found);
        if (kind == "glMaterial") return kind + fmt::format("{} {}", command.enumerant(0), command.enumerant(1));
        return kind == "glMultiTexCoord" ? kind + fmt::format("{}", command.enumerant(0)) : kind;
    }

    std::set<std::string> given_;
};

}  // namespace

CommandRule lists_strips_with_late_attributes() {
    return any_command([at = LateAttributes()](const Command& command) mutable {
        return at(command) && at.is_in_list && at.mode == kGL_TRIANGLE_STRIP && at.vertices % 2 == 1;
    });
}

CommandRule lists_attributes_after_vertices() {
    return any_command([at = LateAttributes(), is_last = false](const Command& command) mutable {
        if (command.id == Id::glBegin) is_last = false;
        if (command.id == Id::glEnd) return at.is_in_list && is_last;
        at(command);
        is_last = at.mode && !LateAttributes::is_vertex(command) && (is_last || LateAttributes::gives(command));
        return false;
    });
}

CommandRule executes_listed_loops() {
    return any_command([at = LateAttributes(), executes = false](const Command& command) mutable {
        if (command.id == Id::glNewList) executes = command.enumerant(1) == kGL_COMPILE_AND_EXECUTE;
        at(command);
        return at.is_in_list && executes && at.mode == kGL_LINE_LOOP && at.vertices > 0 &&
               LateAttributes::gives(command);
    });
}

CommandRule draws_loops_with_late_attributes() {
    return any_command([at = LateAttributes()](const Command& command) mutable {
        return at(command) && at.mode == kGL_LINE_LOOP && (at.is_in_list || at.late > 1);
    });
}

// It keeps colours as floats until it has drawn all of the picture.
CommandRule blends_over_color_sums() {
    return both(any_command([](const Command& command) {
                    const bool separates = command.name().starts_with("glLightModel") &&
                                           command.enumerant(0) == kGL_LIGHT_MODEL_COLOR_CONTROL &&
                                           command.number(1) == kGL_SEPARATE_SPECULAR_COLOR;
                    return separates || (command.id == Id::glEnable && command.enumerant(0) == kGL_COLOR_SUM);
                }),
                any_command([](const Command& command) {
                    return command.id == Id::glEnable && command.enumerant(0) == kGL_BLEND;
                }));
}

// Beyond a viewport as large as the window nothing is seen.
CommandRule attenuates_points_in_viewport() {
    return both(any_command([](const Command& command) { return command.id == Id::glViewport; }),
                any_command([](const Command& command) {
                    return command.name().starts_with("glPointParameter") &&
                           command.enumerant(0) == kGL_POINT_DISTANCE_ATTENUATION;
                }));
}

// What draws these adds a texture of its own.
CommandRule copies_texels_after_smooth_ones() {
    return any_command([is_enabled = false](const Command& command) mutable {
        if (command.id == Id::glEnable) {
            const Enum one = command.enumerant(0);
            is_enabled |= one == kGL_POLYGON_STIPPLE || one == kGL_LINE_SMOOTH || one == kGL_POINT_SMOOTH;
        }
        return is_enabled && is_one_of(command, {"glCopyTexImage", "glCopyTexSubImage"});
    });
}

CommandRule stipples_after_framebuffer() {
    return both(any_command([](const Command& command) { return command.id == Id::glBindFramebuffer; }),
                any_command([](const Command& command) {
                    return command.id == Id::glEnable && command.enumerant(0) == kGL_POLYGON_STIPPLE;
                }));
}

}  // namespace twinlight::compare
