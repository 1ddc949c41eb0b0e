// State: GL's state machine in double precision. Commands go in, a Frame comes out, errors are raised as GL raises them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/command/command.h"
#include "scene/shape/quadric.h"
#include "scene/state/arrays.h"
#include "scene/state/attributes.h"
#include "scene/state/frame.h"
#include "scene/state/gl_error.h"
#include "scene/state/lists.h"
#include "scene/state/pixel_unpacking.h"
#include "scene/state/scene.h"

namespace twinlight {

struct StateOptions {
    int width = 640;  // of the window
    int height = 480;
    SignedRule signed_rule = SignedRule::kGl21;
};

// Limits of Twinlight's own, so that a hostile scene ends with an error (GL_OUT_OF_MEMORY) and not with the machine's memory
// or a day's work: what a picture's clears and draws may hold together, with the textures that they were drawn with and
// that have changed since; and what its display lists, images, shapes and evaluators may come to, counted in commands,
// texels, vertices and points (64 lists that call the next one twice would be 2^64). A recording ends there: the driver
// knows no such limit.
inline constexpr std::size_t kMaxFrameBytes = std::size_t{1} << 30;
inline constexpr std::size_t kMaxFrameWork = 50'000'000;
// How many errors are kept; GL itself keeps one.
inline constexpr std::size_t kMaxErrorsKept = 100;
inline constexpr std::size_t kMaxUnsupportedKept = 200;  // different names; what is beyond counts under one of its own

// RULING: a vertex that is given NaN or infinity. A position of them is (0, 0, 0, 0), which belongs to no polygon, line or
// point (2.12); a normal of them is zero; such a component of a colour or a texture coordinate is 0.
void sanitize(Vertex& vertex);

class State {
  public:
    explicit State(const StateOptions& options = {});

    // Carries one command out. A command with an error changes nothing but errors() (2.5).
    void apply(const Command& command);

    // The first errors, kMaxErrorsKept of them at most; and how many there were.
    const std::vector<GlError>& errors() const { return errors_; }
    std::size_t error_count() const { return error_count_; }
    // The first GL_OUT_OF_MEMORY: the scene asks for more than Twinlight gives, and the driver must not be asked for it.
    const std::optional<GlError>& exhausted() const { return exhausted_; }

    // A call of a function that Twinlight does not have. What it would have changed is not known, so it stands in all
    // pictures from here on.
    void outside(std::string_view function, const Place& place);

    // What must be whole at the end of a scene: Begin/End, matrix stacks. The message of the first thing left open.
    std::optional<GlError> unfinished() const;

    // The picture so far.
    const std::vector<std::variant<Clear, Draw>>& items() const { return items_; }
    bool inside_begin() const { return open_.has_value(); }
    // Forgets it: what is drawn from here on begins a new one.
    void drop_picture();
    // Forgets what the last Clear hides, if that clears everything.
    void drop_hidden();
    // Gives it away.
    Frame take_frame();

    // The values in force.
    const Attributes& attributes() const { return a_; }
    const LightingState& lighting() const { return a_.lighting; }
    const RasterState& raster() const { return a_.raster; }
    const glm::dmat4& modelview() const { return modelview_.back().matrix; }
    const glm::dmat4& projection() const { return projection_.back().matrix; }
    const glm::dmat4& texture_matrix() const { return texture_[a_.active_unit].back().matrix; }
    std::size_t matrix_depth(Enum mode) const;  // of the stack of GL_MODELVIEW, GL_PROJECTION or GL_TEXTURE
    std::size_t attribute_depth() const { return attribute_stack_.size(); }
    Enum render_mode() const { return render_mode_; }
    const VertexArrays& arrays() const { return arrays_; }
    const Lists& lists() const { return lists_; }
    const PixelStore& pixel_store() const { return pixel_store_; }
    const Texture& bound_texture(Enum target) const { return *texture_of(unit(), target); }
    // glIsEnabled (6.1.1): nothing for what is no capability.
    std::optional<bool> capability(Enum cap) const;
    // glGetLight, glGetMaterial (6.1.3); empty for names that GL does not know.
    std::vector<double> get_light(Enum light, Enum pname) const;
    std::vector<double> get_material(Enum face, Enum pname) const;
    const TextureObjects& textures() const { return textures_; }

  private:
    struct StackedMatrix {
        glm::dmat4 matrix{1};
        Place pushed;  // where glPushMatrix stood
    };
    using MatrixStack = std::vector<StackedMatrix>;

    // One function an effect of commands.def; a list for each file of them.
    using Effect = void(const Command&);
    Effect push_attrib, pop_attrib;
    Effect enable, disable;
    Effect client_arrays, array_element, draw_arrays;
    Effect draw_buffer, driver_only_state, driver_only_drawing, driver_only_vertex, driver_only_attribute,
        driver_only_query, driver_only_secondary_color, driver_only_point_parameter, driver_only_pixel_transfer,
        driver_only_bitmap, driver_only_stipple, driver_only_copy_image;
    Effect clear_depth, clear_color, clear, scissor, alpha_func, blend_func, blend_color, color_mask, fog,
        blend_equation;
    Effect light, material, light_model, color_material, shade_model, get_light, get_material, specular_model,
        ambient_model, spot_cone, extra_light;
    Effect gen_lists, new_list, end_list, delete_lists, list_base, call_list, call_lists;
    Effect matrix_mode, load_identity, push_matrix, pop_matrix, load_matrix, mult_matrix, rotate, scale, translate,
        frustum, ortho, perspective, ortho_2d, look_at, viewport, clip_plane, load_transpose_matrix,
        mult_transpose_matrix;
    Effect build_mipmaps, texture_file;
    Effect front_face, cull_face, polygon_mode, depth_func, depth_mask, flush, depth_range, polygon_offset, line_width,
        point_size, edge_flag, hint;
    Effect render_mode, hit_buffer, is_enabled, query_clip_plane;
    Effect shape, new_quadric, delete_quadric, set_quadric, quadric_shape;
    Effect spectrum, reflectance, illuminant, transfer;
    Effect begin, end, normal, color, vertex, tex_coord, multi_tex_coord, rect;
    Effect pixel_store, tex_image, tex_sub_image;
    Effect bind_texture, active_texture, tex_parameter, tex_env, query_tex_env, query_tex_parameter, gen_textures,
        delete_textures, prioritize_textures;
    // glMaterial; the colour is that of the reflectance where there is one.
    void set_material(const Command&, const Spectrum* reflectance);
    void set_light(LightSource& source, Enum pname, const std::vector<double>& values) const;

    void carry_out(const Command& command);
    bool compile(const Command& command);
    std::optional<ArrayVertices> array_vertices(const Command& draw);  // nothing, and the error, for a wrong one
    void draw(const Command& command, const ArrayVertices& read);
    void send_element(const Command& command, const ArrayVertices& element);  // of glArrayElement
    // Whether the picture still has room for so many more bytes, or so much more work; GL_OUT_OF_MEMORY if not.
    bool has_room(const Command& command, std::size_t bytes);
    std::size_t bytes_of_draw() const { return sizeof(Draw) + a_.lighting.lights.size() * sizeof(LightSource); }
    bool has_time(const Command& command, double work);
    std::size_t compile_calls(const Command& command);
    bool walk_calls(const Command& command, const DisplayList& list);
    void execute_list(const Command& command, std::uint32_t name);
    void execute_listed(const ListedCommand& listed);
    void raise_inside(const Command& command);  // of a command that stands between Begin and End
    void raise(GlError error);
    template <class... Values>
    void raise(Enum code, const Command& command, fmt::format_string<Values...> message, Values&&... values) {
        raise(refused(code, command, message, std::forward<Values>(values)...));
    }
    // Whether `value` is one of `allowed`; raises GL_INVALID_ENUM if not.
    bool known(const Command& command, Enum value, std::initializer_list<Enum> allowed);
    LightSource* light_source(const Command& command, Enum light);  // null, and GL_INVALID_ENUM, for no light
    // The values of glLight*, glMaterial*, glFog*, glTexEnv*, ... as real numbers; nothing, and the error, if they are refused.
    std::optional<std::vector<double>> parameter_values(const Command& command, Owner owner, Enum pname);
    void set_capability(const Command& command, bool enabled);
    bool known_capability(const Command& command);  // or GL_INVALID_ENUM
    // The texture that a glTex* command changes: one that no Draw holds. Null, and the error, for a wrong target.
    Texture* writable_texture(const Command& command, Enum target);
    const std::shared_ptr<Texture>& texture_of(const TextureBindings& bindings, Enum target) const;
    std::shared_ptr<const Texture> complete_texture(const TextureBindings& bindings) const;
    TextureBindings& unit() { return a_.units[a_.active_unit]; }
    const TextureBindings& unit() const { return a_.units[a_.active_unit]; }
    bool check_pixel_type(const Command& command, const PixelSource& source);
    std::optional<PixelRows> pixels(const Command& command, const PixelSource& source);
    void generate_mipmaps(Texture& texture) const;
    // Whether there is room and time for so many texels more, some of which replace others; GL_OUT_OF_MEMORY if not.
    bool has_texels(const Command& command, double count, std::size_t replaced = 0);
    bool counts(const Command& command, const char* what);  // n >= 0, or GL_INVALID_VALUE
    void track_color();                                     // 2.14.3: the material follows the current colour
    void multiply(const glm::dmat4& matrix);
    MatrixStack& stack();
    std::size_t stack_limit() const;
    Draw new_draw(Enum mode, const Place& place);
    void send_shape(const Command& command, std::vector<ShapePart> parts, std::vector<Surface> surfaces);
    Quadric* quadric(const Command& command);   // its first argument; null, and the error, where there is none
    bool can_send(const Command& command);      // whether its quadric can be sent; false, and the error, if not
    void show(std::variant<Clear, Draw> item);  // adds it to the picture, in the mode that makes one
    void note_driver_only_values(const Draw& draw);
    // Of what is drawn now, and of what changes all pictures from here on.
    void note_lasting(std::string_view name, const Place& place);
    void note_unsupported(const std::string& name, const Place& place, MissingFrom missing_from = MissingFrom::kFrame);
    double to_real(double c,
                   Kind kind) const;  // a colour's or normal's component: integers to [-1,1] or [0,1]

    struct SavedAttributes {
        Attributes attributes;
        Enum mask = 0;
        Texture texture_1d, texture_2d;  // the parameters of the bound textures (table 6.16)
        Place pushed;
    };

    StateOptions options_;
    Attributes a_;
    TextureObjects textures_;
    PixelStore pixel_store_;
    std::vector<std::optional<PixelStore>> saved_pixel_stores_;  // by glPushClientAttrib, a level each
    VertexArrays arrays_;
    Lists lists_;
    MatrixStack modelview_{{}}, projection_{{}};
    std::vector<MatrixStack> texture_{kMaxTextureUnits, MatrixStack{{}}};  // a unit each
    std::vector<SavedAttributes> attribute_stack_;
    Enum render_mode_ = kGL_RENDER;                      // 5.2
    bool has_selection_ = false, has_feedback_ = false;  // a buffer of some size
    std::optional<Draw> open_;                           // between Begin and End
    std::map<double, Quadric> quadrics_;                 // by number
    std::map<double, Place> deleted_quadrics_;           // where gluDeleteQuadric stood
    std::vector<std::variant<Clear, Draw>> items_;
    std::size_t item_bytes_ = 0;  // what items_ holds, about
    double work_ = 0;             // for this picture, so far
    std::vector<Unsupported> unsupported_;
    std::vector<Unsupported> outside_;
    std::vector<GlError> errors_;
    std::size_t error_count_ = 0;
    std::optional<GlError> exhausted_;
};

// Runs all commands of a scene. Throws SceneError at the first GL error, at what is left open at the end, and for commands
// that draw nothing.
Frame make_frame(const CommandList& commands, const StateOptions& options);
Scene make_scene(std::shared_ptr<const CommandList> commands, const StateOptions& options);

}  // namespace twinlight
