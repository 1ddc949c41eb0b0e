// Rules about materials and colours.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text/translation.h"
#include "judge/lint/watch.h"

namespace twinlight::lint {

namespace {

bool tracks(Enum mode, Enum pname) {
    if (mode == kGL_AMBIENT_AND_DIFFUSE) return pname == kGL_AMBIENT || pname == kGL_DIFFUSE || pname == mode;
    return pname == mode || (pname == kGL_AMBIENT_AND_DIFFUSE && (mode == kGL_AMBIENT || mode == kGL_DIFFUSE));
}

bool overlap(Enum face, Enum other) {
    return face == kGL_FRONT_AND_BACK || other == kGL_FRONT_AND_BACK || face == other;
}

// glColor whose every use is in lit Draws without GL_COLOR_MATERIAL.
class ColorIgnored : public Watch {
  public:
    void after(const Command& command, const State& state) override {
        const bool is_color = is_effect(command, "color");
        if (is_color && !state.inside_begin()) settle();
        if (is_color) open_.push_back(command);
        if (state.lighting().color_material.enabled) used_ = true;
    }
    void drawn(const Draw& draw, const State&) override {
        const bool is_overlay = overlays_.is_overlay(draw);  // lit-overlay warns about its colour
        (draw.lighting.enabled && !draw.lighting.color_material.enabled && !is_overlay ? ignored_ : used_) = true;
    }
    void finish(const Frame&, bool) override { settle(); }

  private:
    void settle() {
        if (ignored_ && !used_) {
            for (const Command& command : open_)
                warn({.place = command.place,
                      .message =
                          tr("this glColor has no effect: the object is lit, and GL_COLOR_MATERIAL is not enabled"),
                      .fix = tr("glEnable(GL_COLOR_MATERIAL); or glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, ...)"),
                      .edits = {{.place = command.place, .insert = "glEnable(GL_COLOR_MATERIAL);"}}});
        }
        open_.clear();
        ignored_ = used_ = false;
    }

    LitOverlays overlays_;
    std::vector<Command> open_;  // since the last settled one
    bool ignored_ = false, used_ = false;
};

// Properties that glEnable(GL_COLOR_MATERIAL) overwrote before glColorMaterial chose others.
class ColorMaterialTooEarly : public Watch {
  public:
    void before(const Command& command, const State& state) override {
        if (is_effect(command, "enable")) material_ = state.lighting().front;
    }
    void after(const Command& command, const State& state) override {
        const LightingState& lighting = state.lighting();
        if (is_effect(command, "enable") && command.enumerant(0) == kGL_COLOR_MATERIAL &&
            lighting.color_material.mode == kGL_AMBIENT_AND_DIFFUSE) {
            enabled_ = command.place;
            overwritten_ = lighting.front.diffuse != material_.diffuse || lighting.front.ambient != material_.ambient;
            has_drawn_ = false;
        }
        if (!is_effect(command, "color_material")) return;
        if (enabled_.line > 0 && lighting.color_material.enabled && overwritten_ && !has_drawn_ &&
            command.enumerant(1) != kGL_AMBIENT_AND_DIFFUSE) {
            pending_ = enabled_;
            chosen_ = command.place;
            left_ = lighting.front;
            mode_ = command.enumerant(1);
        }
        enabled_ = {};
    }
    void drawn(const Draw& draw, const State&) override {
        has_drawn_ = true;
        if (pending_.line == 0 || !draw.lighting.enabled) return;
        const Material& now = draw.lighting.front;
        const bool keeps = (mode_ != kGL_DIFFUSE && now.diffuse == left_.diffuse) ||
                           (mode_ != kGL_AMBIENT && now.ambient == left_.ambient);
        if (keeps)
            warn({.place = pending_,
                  .message = tr("GL_COLOR_MATERIAL is enabled before glColorMaterial ({}), so the current colour "
                                "has already replaced the ambient and diffuse colours",
                                where(chosen_)),
                  .fix = tr("call glColorMaterial first, then glEnable(GL_COLOR_MATERIAL)"),
                  .edits = {{.place = chosen_, .is_after = true, .moved = pending_}},
                  .key = "early"});
        pending_ = {};
    }

  private:
    Material material_, left_;
    Place enabled_, pending_, chosen_;
    bool overwritten_ = false, has_drawn_ = false;
    Enum mode_ = 0;
};

// glMaterial of a property that follows the current colour, for all faces that it names and that count.
class MaterialOverridden : public Watch {
  public:
    void after(const Command& command, const State& state) override {
        const ColorMaterial& tracking = state.lighting().color_material;
        if (is_effect(command, "disable") && command.enumerant(0) == kGL_COLOR_MATERIAL) open_.clear();
        if (!is_effect(command, "material") || !tracking.enabled) return;
        if (!tracks(tracking.mode, pname_of(command)) || !overlap(tracking.face, command.enumerant(0))) return;
        // A property beside the tracked one is set as well.
        if (pname_of(command) == kGL_AMBIENT_AND_DIFFUSE && tracking.mode != kGL_AMBIENT_AND_DIFFUSE) return;
        const auto values = command.array();
        bool differs = false;
        for (int i = 0; i < 3 && i < static_cast<int>(values.size()); ++i)
            differs |= std::abs(values[static_cast<std::size_t>(i)] - state.attributes().current.color[i]) > 0.002;
        if (differs) open_.push_back(command);
    }
    void drawn(const Draw& draw, const State&) override {
        const ColorMaterial& tracking = draw.lighting.color_material;
        if (!draw.lighting.enabled || !tracking.enabled) return;
        for (const Command& command : open_) {
            // Without two-sided lighting, both faces have the front's material.
            const Enum named = command.enumerant(0),
                       counts = !draw.lighting.light_model.two_side && named == kGL_FRONT_AND_BACK ? kGL_FRONT : named;
            if (tracking.face != kGL_FRONT_AND_BACK && tracking.face != counts) continue;
            warn({.place = command.place,
                  .message = tr("this {} has no effect: GL_COLOR_MATERIAL is enabled, so glColor sets it",
                                enum_name(pname_of(command))),
                  .fix = tr("glDisable(GL_COLOR_MATERIAL); before it, or use glColor"),
                  .edits = {{.place = command.place, .insert = "glDisable(GL_COLOR_MATERIAL);"}}});
        }
        open_.clear();
    }

  private:
    std::vector<Command> open_;  // since the last Draw
};

// glColorMaterial(GL_BACK, ...), where only the front's material counts.
class ColorMaterialOfTheBack : public Watch {
  public:
    void after(const Command& command, const State&) override {
        if (is_effect(command, "color_material")) chosen_ = command;
        if (is_effect(command, "color")) has_color_ = true;
    }
    void drawn(const Draw& draw, const State&) override {
        const ColorMaterial& tracking = draw.lighting.color_material;
        if (!draw.lighting.enabled || !tracking.enabled || !chosen_) return;
        if (!has_color_ || tracking.face != kGL_BACK || draw.lighting.light_model.two_side) return;
        const std::string call = fmt::format("glColorMaterial(GL_FRONT_AND_BACK, {});", enum_name(tracking.mode));
        warn({.place = chosen_->place,
              .message =
                  tr("glColor has no effect: this glColorMaterial replaces all earlier ones, and so only the back's "
                     "material follows glColor, but lighting is one-sided, so both faces have the front's"),
              .fix = call,
              .edits = {{.place = chosen_->place, .removes = true, .insert = call}},
              .key = "back"});
    }

  private:
    std::optional<Command> chosen_;
    bool has_color_ = false;
};

// The emission of one object that later objects, which get colours of their own, still have.
class EmissionStays : public Watch {
  public:
    void after(const Command& command, const State& state) override {
        if (!is_effect(command, "material") || command.enumerant(0) == kGL_BACK) return;
        if (pname_of(command) == kGL_EMISSION) {
            const glm::dvec4& color = state.lighting().front.emission;
            constexpr double kGlows = 0.3;
            emission_.reset();
            if (std::max({color.r, color.g, color.b}) >= kGlows) emission_ = command;
            has_drawn_ = false;
            next_ = {};
        } else if (emission_ && has_drawn_ && next_.line == 0 && pname_of(command) != kGL_SHININESS) {
            next_ = command.place;
        }
    }
    void drawn(const Draw& draw, const State&) override {
        if (!emission_ || !draw.lighting.enabled) return;
        has_drawn_ = true;
        if (next_.line == 0) return;
        const std::string call = fmt::format("glMaterialfv({}, GL_EMISSION, (GLfloat[]){{0, 0, 0, 1}});",
                                             enum_name(emission_->enumerant(0)));
        warn({.place = emission_->place,
              .message = tr("this GL_EMISSION is never taken back: the objects after {} glow, too", where(next_)),
              .fix = tr("{} after the object that glows", call),
              .edits = {{.place = next_, .insert = call}}});
        emission_.reset();
    }

  private:
    std::optional<Command> emission_;  // bright, and still set
    bool has_drawn_ = false;           // with it
    Place next_;                       // the next glMaterial of another colour
};

// What of the front's material commands have set.
class MaterialWatch : public Watch {
  public:
    void after(const Command& command, const State&) override {
        if (!is_effect(command, "material")) return;
        for (const Enum face : {kGL_FRONT, kGL_BACK})
            if (overlap(face, command.enumerant(0))) set_[{face, pname_of(command)}] = command;
    }

  protected:
    const Command* set(Enum pname) const {
        const auto found = set_.find({kGL_FRONT, pname});
        return found == set_.end() ? nullptr : &found->second;
    }
    std::map<std::pair<Enum, Enum>, Command> set_;
};

class ShininessWithoutSpecular : public MaterialWatch {
  public:
    void drawn(const Draw& draw, const State&) override {
        const Material& front = draw.lighting.front;
        is_lit_ |= draw.lighting.enabled && front.shininess > 0;
        has_specular_ |= !is_black(front.specular);
    }
    void finish(const Frame&, bool) override {
        const Command* shininess = set(kGL_SHININESS);
        if (!is_lit_ || has_specular_ || !shininess || set(kGL_SPECULAR)) return;
        const std::string call = fmt::format("glMaterialfv({}, GL_SPECULAR, (GLfloat[]){{1, 1, 1, 1}});",
                                             enum_name(shininess->enumerant(0)));
        warn({.place = shininess->place,
              .message = tr("GL_SHININESS has no effect: the material's specular colour is black, its initial value"),
              .fix = call,
              .edits = {{.place = shininess->place, .insert = call}}});
    }

  private:
    bool is_lit_ = false, has_specular_ = false;
};

class SpecularWithoutShininess : public MaterialWatch {
  public:
    void drawn(const Draw& draw, const State& state) override {
        const Command* specular = set(kGL_SPECULAR);
        if (!specular || set(kGL_SHININESS) || !has_specular_light(draw) || state.lighting().front.shininess != 0 ||
            is_black(draw.lighting.front.specular))
            return;
        const std::string call = fmt::format("glMaterialf({}, GL_SHININESS, 32);", enum_name(specular->enumerant(0)));
        warn({.place = specular->place,
              .message = tr("the highlight covers the whole lit side: GL_SHININESS is 0, its initial value"),
              .fix = call,
              .edits = {{.place = specular->place, .insert = call, .is_after = true}},
              .key = "shininess"});
    }
};

class ShininessFraction : public MaterialWatch {
  public:
    void drawn(const Draw& draw, const State&) override {
        const Command* shininess = set(kGL_SHININESS);
        const Material& front = draw.lighting.front;
        if (!shininess || !has_specular_light(draw) || is_black(front.specular)) return;
        if (front.shininess <= 0 || front.shininess >= 1) return;
        warn({.place = shininess->place,
              .message = tr("GL_SHININESS is {:.4g}: in tables of materials such values are fractions of 128, "
                            "but GL's range is 0 to 128",
                            front.shininess),
              .fix = fmt::format("glMaterialf({}, GL_SHININESS, {:.4g});", enum_name(shininess->enumerant(0)),
                                 front.shininess * 128),
              .edits = {{.place = shininess->place,
                         .removes = true,
                         .insert = fmt::format("glMaterialf({}, GL_SHININESS, {:.4g});",
                                               enum_name(shininess->enumerant(0)), front.shininess * 128)}}});
    }
};

class BackMaterialOneSided : public MaterialWatch {
  public:
    void drawn(const Draw& draw, const State&) override {
        is_lit_ |= draw.lighting.enabled;
        is_two_sided_ |= draw.lighting.light_model.two_side;
    }
    void after(const Command& command, const State& state) override {
        MaterialWatch::after(command, state);
        if (is_effect(command, "material") && command.enumerant(0) == kGL_BACK && place_.line == 0)
            place_ = command.place;
    }
    void finish(const Frame&, bool) override {
        if (place_.line == 0 || !is_lit_ || is_two_sided_) return;
        const std::string call = "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);";
        warn({.place = place_,
              .message =
                  tr("the material of GL_BACK has no effect: lighting is one-sided, so both faces have the front's"),
              .fix = call,
              .edits = {{.place = place_, .insert = call}}});
    }

  private:
    Place place_;
    bool is_lit_ = false, is_two_sided_ = false;
};

// Transparency given to something else than the diffuse colour.
class AlphaNotDiffuse : public MaterialWatch {
  public:
    void after(const Command& command, const State& state) override {
        MaterialWatch::after(command, state);
        if (is_effect(command, "color")) color_ = command;
    }
    void drawn(const Draw& draw, const State&) override {
        const FragmentState& fragment = draw.fragment;
        if (!draw.lighting.enabled || !fragment.blend || fragment.blend_src != kGL_SRC_ALPHA ||
            draw.lighting.front.diffuse.a != 1 || draw.texture.texture)
            return;
        const bool tracks_diffuse =
            draw.lighting.color_material.enabled && tracks(draw.lighting.color_material.mode, kGL_DIFFUSE);
        const Command* found = nullptr;
        if (draw.lighting.front.ambient.a < 1) found = set(kGL_AMBIENT);
        if (!found && draw.lighting.front.specular.a < 1) found = set(kGL_SPECULAR);
        if (!found && draw.lighting.front.emission.a < 1) found = set(kGL_EMISSION);
        if (!found && color_ && !tracks_diffuse && draw.vertices.front().color.a < 1) found = &*color_;
        if (!found || found->arguments.empty() || found->arguments.back() >= 1) return;
        warn({.place = found->place,
              .message = tr(
                  "this alpha has no effect: a lit vertex has the alpha of the material's diffuse colour, which is 1"),
              .fix =
                  tr("give the alpha to GL_DIFFUSE: glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){r, g, b, alpha})")});
    }

  private:
    std::optional<Command> color_;
};

class FlatDropsColors : public Watch {
    void drawn(const Draw& draw, const State&) override {
        if (draw.lighting.shade_model != kGL_FLAT) return;
        const bool shows_colors = !draw.lighting.enabled || draw.lighting.color_material.enabled;
        if (!shows_colors) return;
        for (const Triangle& triangle : triangles_of(draw)) {
            const glm::dvec4& color = draw.vertices[triangle[0]].color;
            if (color == draw.vertices[triangle[1]].color && color == draw.vertices[triangle[2]].color) continue;
            warn({.place = draw.place,
                  .message =
                      tr("the vertices of a polygon have different colours, but GL_FLAT shows only one of them: that "
                         "of the last vertex (of a GL_POLYGON: the first)"),
                  .fix = "glShadeModel(GL_SMOOTH);",
                  .edits = {{.place = draw.place, .insert = "glShadeModel(GL_SMOOTH);"}}});
            return;
        }
    }
};

class TextureReplacesLight : public Watch {
    void drawn(const Draw& draw, const State&) override {
        if (enabled_lights(draw).empty() || !draw.texture.texture || draw.texture.texture->levels.empty()) return;
        const Enum format = draw.texture.texture->base_format();
        if (draw.texture.env_mode != kGL_REPLACE || format == kGL_ALPHA || draw.combines_textures()) return;
        warn(
            {.place = draw.place,
             .message = tr("lighting has no effect on this object: its texture replaces the lit colour (GL_REPLACE)"),
             .fix = "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);",
             .edits = {{.place = draw.place, .insert = "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);"}},
             .key = "replace"});
    }
};

// GL ignores an enabled texture that is incomplete.
class TextureIncomplete : public Watch {
  public:
    void after(const Command& command, const State& state) override {
        if (!is_effect(command, "tex_image") || command.number(1) != 0) return;
        const Enum target = command.enumerant(0);
        if (target == kGL_TEXTURE_1D || target == kGL_TEXTURE_2D || target == kGL_TEXTURE_3D)
            images_[{target, state.attributes().units[0].bound(target)}] = command.place;
    }
    void drawn(const Draw& draw, const State& state) override {
        const TextureBindings& unit = state.attributes().units[0];
        if (!unit.is_enabled() || draw.texture.texture) return;
        const Enum target = unit.target();
        const auto image = images_.find({target, unit.bound(target)});
        if (image == images_.end()) return;
        const std::string call =
            fmt::format("glTexParameteri({}, GL_TEXTURE_MIN_FILTER, GL_LINEAR);", enum_name(target));
        warn({.place = image->second,
              .message =
                  tr("this texture has no effect: its GL_TEXTURE_MIN_FILTER needs mipmaps, and not all levels are "
                     "there"),
              .fix = call,
              .edits = {{.place = image->second, .insert = call, .is_after = true}}});
    }

  private:
    std::map<std::pair<Enum, std::uint32_t>, Place> images_;  // of level 0, by the texture's target and name
};

// A highlight that a texture darkens, where a secondary colour would keep it.
class TextureDimsHighlight : public MaterialWatch {
    void drawn(const Draw& draw, const State&) override {
        const Command* shininess = set(kGL_SHININESS);
        if (!shininess || !has_specular_light(draw) || !draw.texture.texture || draw.texture.texture->levels.empty() ||
            draw.texture.texture->has_copies())
            return;
        const bool is_dark = std::ranges::any_of(draw.texture.texture->levels[0].texels, [](const glm::vec4& texel) {
            return texel.r < 0.25F && texel.g < 0.25F && texel.b < 0.25F;
        });
        if (!is_dark || draw.texture.env_mode != kGL_MODULATE || is_black(draw.lighting.front.specular) ||
            draw.lighting.front.shininess < 1 || draw.lighting.light_model.color_control != kGL_SINGLE_COLOR)
            return;
        const std::string call = "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);";
        warn({.place = shininess->place,
              .message = tr("the texture darkens the highlight: it multiplies the specular colour too"),
              .fix = call,
              .edits = {{.place = shininess->place, .insert = call}},
              .key = "texture"});
    }
};

// Values of lights and materials that are set after the last object.
class SetAfterDrawing : public Watch {
  public:
    void before(const Command& command, const State& state) override {
        if (!is_effect(command, "material") && !light_of(command)) return;
        front_ = state.lighting().front;
        lights_ = state.lighting().lights;
    }
    void after(const Command& command, const State& state) override {
        const bool is_material = is_effect(command, "material");
        if (!is_material && !light_of(command)) return;
        since_.emplace(command.place.line, command.place.column);
        const Material initial_material;
        const LightingState initial;
        const Material& front = state.lighting().front;
        bool is_new = false;
        if (is_material) {
            is_new = (front.diffuse != front_.diffuse && front.diffuse != initial_material.diffuse) ||
                     (front.ambient != front_.ambient && front.ambient != initial_material.ambient) ||
                     (front.specular != front_.specular && !is_black(front.specular)) ||
                     (front.shininess != front_.shininess && front.shininess != 0);
        } else {
            const auto at = static_cast<std::size_t>(*light_of(command));
            const LightSource &was = std::as_const(lights_)[at], &is = state.lighting().lights[at];
            is_new = is.enabled && (is.diffuse != was.diffuse || is.position_eye != was.position_eye ||
                                    is.ambient != was.ambient || is.specular != was.specular);
        }
        if (is_new) late_.push_back(command);
    }
    void drawn(const Draw& draw, const State&) override {
        last_ = draw.place;
        late_.clear();
        used_.merge(since_);
        since_.clear();
        is_lit_ |= draw.lighting.enabled;
    }
    void finish(const Frame&, bool is_recorded) override {
        if (is_recorded || !is_lit_) return;
        for (const Command& command : late_) {
            // A function that also sets values for objects.
            if (used_.contains({command.place.line, command.place.column})) continue;
            warn({.place = command.place,
                  .message = tr("this {} comes after the last object ({}), so no object uses it",
                                enum_name(pname_of(command)), where(last_)),
                  .fix = tr("call it before the object that it is for"),
                  .edits = {{.place = last_, .moved = command.place}}});
        }
    }

  private:
    Material front_;
    LightSources lights_ = LightingState().lights;
    std::vector<Command> late_;
    std::set<std::pair<int, int>> since_, used_;  // places of commands since the last Draw, and before one
    Place last_;
    bool is_lit_ = false;
};

}  // namespace

std::vector<Rule> material_rules() {
    return {
        {"color-ignored",
         "`glColor` sets the colour of a lit object, but `GL_COLOR_MATERIAL` is not enabled. It has no effect.",
         "Section 2.14.1: with lighting the colour comes from the material. Section 2.14.3: only `GL_COLOR_MATERIAL` "
         "makes it follow `glColor`.",
         "glEnable(GL_COLOR_MATERIAL);",
         R"(// the view
// the light
+glEnable(GL_COLOR_MATERIAL);
 glColor3f(1, 0.3, 0.2);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<ColorIgnored>},
        {"color-material-too-early",
         "`GL_COLOR_MATERIAL` is enabled before `glColorMaterial` chooses what follows the colour. The ambient and "
         "diffuse colours already have the current colour, and keep it.",
         "Section 2.14.3: from the moment of `glEnable` the chosen colours follow the current colour; initially these "
         "are ambient and diffuse.",
         "glColorMaterial(GL_FRONT, ...); glEnable(GL_COLOR_MATERIAL);",
         R"(// the view
// the light
 glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0.3, 0.2, 1});
 glMaterialf(GL_FRONT, GL_SHININESS, 32);
-glEnable(GL_COLOR_MATERIAL);
 glColorMaterial(GL_FRONT, GL_SPECULAR);
+glEnable(GL_COLOR_MATERIAL);
 glColor3f(0.5, 0.5, 0.5);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<ColorMaterialTooEarly>},
        {"material-overridden",
         "`glMaterial` sets a colour that follows `glColor`, because `GL_COLOR_MATERIAL` is enabled. It has no effect.",
         "Section 2.14.3: while `GL_COLOR_MATERIAL` is enabled, the chosen colours are the current colour.",
         "glDisable(GL_COLOR_MATERIAL);",
         R"(// the view
// the light
 glEnable(GL_COLOR_MATERIAL);
+glDisable(GL_COLOR_MATERIAL);
 glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0.3, 0.2, 1});
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<MaterialOverridden>},
        {"color-material-back",
         "`glColorMaterial` names only `GL_BACK`, but lighting is one-sided, so `glColor` changes nothing. Often there "
         "are "
         "two calls, one for each side: only the last counts.",
         "Section 2.14.3: a `glColorMaterial` replaces the one before. Section 2.14.1: without "
         "`GL_LIGHT_MODEL_TWO_SIDE` both faces have the colour of the front's material.",
         "glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);",
         R"(// the view
// the light
-glColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
-glColorMaterial(GL_BACK, GL_AMBIENT_AND_DIFFUSE);
+glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
 glEnable(GL_COLOR_MATERIAL);
 glColor3f(1, 0.2, 0.1);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<ColorMaterialOfTheBack>},
        {"emission-stays",
         "The `GL_EMISSION` of an object is never taken back. The objects after it, which get colours of their own, "
         "glow "
         "as well.",
         "Section 2.14.2: a material keeps each property until the next `glMaterial` of it. Section 2.14.1: the "
         "emission "
         "is added whatever the lights are.",
         "glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){0, 0, 0, 1});",
         R"(// the view
// the light
 glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){1, 0.8, 0.2, 1});
 glutSolidSphere(0.8, 40, 20);
+glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){0, 0, 0, 1});
 glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){0.2, 0.4, 0.9, 1});
 glTranslatef(1.6, 0, 0);
 glutSolidSphere(0.4, 40, 20);
)",
         make_watch<EmissionStays>},
        {"shininess-without-specular",
         "`GL_SHININESS` is set, but the specular colour of the material is black, its initial value. There is no "
         "highlight.",
         "Section 2.14.1: the highlight is multiplied by the material's specular colour; initially (0, 0, 0, 1), table "
         "2.10.",
         "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});",
         R"(// the view
// the light
+glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});
 glMaterialf(GL_FRONT, GL_SHININESS, 32);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<ShininessWithoutSpecular>},
        {"specular-without-shininess",
         "The specular colour is set, but not `GL_SHININESS`. It is 0, so the highlight covers the whole lit side. (A "
         "larger shininess makes a smaller highlight.)",
         "Section 2.14.1: the highlight is (n . h)^0 = 1 wherever the light reaches.",
         "glMaterialf(GL_FRONT, GL_SHININESS, 32);",
         R"(// the view
// the light
 glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});
+glMaterialf(GL_FRONT, GL_SHININESS, 32);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<SpecularWithoutShininess>},
        {"shininess-fraction",
         "`GL_SHININESS` is between 0 and 1, as in tables of materials that give fractions of 128. The highlight "
         "covers the whole lit side.",
         "Section 2.14.1: the shininess is an exponent from 0 to 128. Values of other formats need their own factor: "
         "an OBJ file's go to 1000.",
         "glMaterialf(GL_FRONT, GL_SHININESS, 0.25 * 128);",
         R"(// the view
// the light
 glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});
-glMaterialf(GL_FRONT, GL_SHININESS, 0.25);
+glMaterialf(GL_FRONT, GL_SHININESS, 0.25 * 128);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<ShininessFraction>},
        {"back-material-one-sided",
         "A material is set for `GL_BACK`, but lighting is one-sided. Back faces show the front's material.",
         "Section 2.14.1: without `GL_LIGHT_MODEL_TWO_SIDE` both faces have the colour of the front's material and "
         "normal.",
         "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);",
         R"(// the view
// the light
+glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
 glMaterialfv(GL_BACK, GL_DIFFUSE, (GLfloat[]){1, 0.2, 0.1, 1});
 glutSolidSphere(0.5, 40, 20);
 glBegin(GL_TRIANGLES);
 glNormal3f(0, 0, -1);
 glVertex3f(-2, -1, 0);
 glVertex3f(0, 2, 0);
 glVertex3f(2, -1, 0);
 glEnd();
)",
         make_watch<BackMaterialOneSided>},
        {"alpha-not-diffuse",
         "A lit object is blended, and an alpha below 1 is given to a colour other than the diffuse one. It has no "
         "effect.",
         "Section 2.14.1: the alpha of a lit vertex is that of the material's diffuse colour.",
         "glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){r, g, b, 0.5});",
         R"(// the view
// the light
 glEnable(GL_BLEND);
 glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
-glMaterialfv(GL_FRONT, GL_AMBIENT, (GLfloat[]){0.2, 0.2, 0.2, 0.4});
+glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){0.8, 0.8, 0.8, 0.4});
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<AlphaNotDiffuse>},
        {"flat-drops-colors",
         "The vertices of a polygon have different colours, but `GL_FLAT` shows only that of its provoking vertex.",
         "Section 2.14.7, table 2.12: the colour of the last vertex of a triangle or quadrilateral, of the first of a "
         "`GL_POLYGON`.",
         "glShadeModel(GL_SMOOTH);",
         R"(// the view
-glShadeModel(GL_FLAT);
+glShadeModel(GL_SMOOTH);
 glBegin(GL_TRIANGLES);
 glColor3f(1, 0, 0);
 glVertex3f(-2, -1, 0);
 glColor3f(0, 1, 0);
 glVertex3f(2, -1, 0);
 glColor3f(0, 0, 1);
 glVertex3f(0, 2, 0);
 glEnd();
)",
         make_watch<FlatDropsColors>},
        {"texture-incomplete",
         "A texture is enabled, but its minification filter needs mipmaps, and there are none. The object is drawn "
         "without the texture.",
         "Section 3.8.10: an incomplete texture works as if texturing were disabled. Table 3.18: the initial filter is "
         "`GL_NEAREST_MIPMAP_LINEAR`.",
         "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);",
         R"(// the view
// the light
 GLubyte texels[] = {255, 128, 0, 255, 0, 128, 255, 255};
 glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
+glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
 glEnable(GL_TEXTURE_2D);
 GLUquadric* ball = gluNewQuadric();
 gluQuadricTexture(ball, GL_TRUE);
 gluSphere(ball, 1.5, 40, 20);
)",
         make_watch<TextureIncomplete>},
        {"texture-replaces-light", "A texture with `GL_REPLACE` covers a lit object. The light has no effect.",
         "Section 3.8.13, table 3.21: `GL_REPLACE` takes the colour of the texture and drops that of the vertex.",
         "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);",
         R"(// the view
// the light
 GLubyte texels[] = {255, 128, 0, 255, 0, 128, 255, 255};
 glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
 glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
 glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
-glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
+glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
 glEnable(GL_TEXTURE_2D);
 GLUquadric* ball = gluNewQuadric();
 gluQuadricTexture(ball, GL_TRUE);
 gluSphere(ball, 1.5, 40, 20);
)",
         make_watch<TextureReplacesLight>},
        {"texture-dims-highlight",
         "A texture with dark texels covers an object with a highlight. The texture multiplies the highlight as well.",
         "Section 2.14.1: with `GL_SINGLE_COLOR` the specular term is part of the primary colour, which `GL_MODULATE` "
         "multiplies. Section 3.9: a separate secondary colour is added after texturing.",
         "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);",
         R"(// the view
// the light
 GLubyte texels[] = {30, 20, 10, 255, 40, 40, 60, 255};
 glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
 glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
 glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
 glEnable(GL_TEXTURE_2D);
 glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});
 glMaterialf(GL_FRONT, GL_SHININESS, 32);
+glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
 GLUquadric* ball = gluNewQuadric();
 gluQuadricTexture(ball, GL_TRUE);
 gluSphere(ball, 1.5, 40, 20);
)",
         make_watch<TextureDimsHighlight>},
        {"set-after-drawing", "A light or a material is set after the last object. No object uses it.",
         "Section 2.14.2: values hold for what is drawn after the call, not before.", "call it before the object",
         R"(// the view
// the light
-glutSolidSphere(1.5, 40, 20);
 glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0.3, 0.2, 1});
+glutSolidSphere(1.5, 40, 20);
)",
         make_watch<SetAfterDrawing>},
    };
}

}  // namespace twinlight::lint
