// State: GL's state machine in double precision. It executes commands, raises GL's errors and builds a Frame.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "scene/command/command.h"
#include "scene/frame/frame.h"
#include "scene/frame/scene.h"
#include "scene/shape/quadric.h"
#include "scene/state/arrays.h"
#include "scene/state/attributes.h"
#include "scene/state/evaluators.h"
#include "scene/state/framebuffers.h"
#include "scene/state/gl_error.h"
#include "scene/state/lists.h"
#include "scene/state/pixel_unpacking.h"

namespace twinlight {

struct SceneError;

// The memory that one picture may need, in bytes: its clears and draws, the textures that they used and that have changed
// since, and what the renderers build from its vertices (bytes_of_vertices). More is GL_OUT_OF_MEMORY.
inline constexpr std::size_t kDefaultMemory = 2'000'000'000;

struct StateOptions {
    int width = 640;  // the size of the window in pixels
    int height = 480;
    SignedRule signed_rule = SignedRule::kGl21;
    std::size_t memory = kDefaultMemory;  // in bytes, for one picture: see kDefaultMemory
};

// Twinlight's own limits. They stop a hostile scene with GL_OUT_OF_MEMORY before it fills the memory or runs for hours.
// StateOptions::memory limits what a picture holds. kMaxFrameWork limits its display lists, images, shapes and evaluators, counted in commands, texels, vertices
// and points (64 lists that each call the next one twice would execute 2^64 commands). Drivers have no such limits, so
// a recording ends there.
inline constexpr std::size_t kMaxFrameWork = 50'000'000;
// How many copies may follow each other, each of a picture that shows the one before. A renderer draws a picture for each.
inline constexpr int kMostCopiesInARow = 50;
int copies_in_a_row(const FrameItems& items);  // for what a picture with these items shows
// The number of errors that are stored; GL itself stores one.
inline constexpr std::size_t kMaxErrorsKept = 100;
inline constexpr std::size_t kMaxUnsupportedKept = 200;  // different names; all further ones count as "more commands"

// What `twinlight compare` needs at its peak for the vertices of a Draw, which are drawn in the order of the indices, if there are
// any: their Vertex and StageVertex, the meshes of two renderers, and the reference's Pieces. A triangle that is drawn as lines or
// points becomes three of these. Measured on two processors, with up to 200,000 vertices of a recording: 700 bytes for each of points, 800 of
// a line, 710 of a strip, 2,250 of one that is drawn as lines. A sphere's vertices, of which each is sent twice, need 360 bytes each in a
// picture of 64 x 64, where few triangles cover a pixel's centre, and 930 in one of 1000 x 1000.
inline std::size_t bytes_of_vertices(const RasterState& raster, Enum mode, std::size_t vertices,
                                     std::size_t indices = 0) {
    const bool fills = raster.polygon_mode_front == kGL_FILL && raster.polygon_mode_back == kGL_FILL;
    constexpr std::size_t kVertex = 400, kPoint = 650, kTriangle = 350;
    const std::size_t of_index = !draws_polygons(mode) ? kPoint : fills ? kTriangle : 3 * kPoint;
    return vertices * kVertex + (indices > 0 ? indices : vertices) * of_index;
}
// The same for the texture coordinates of a texture unit above 0.
constexpr std::size_t bytes_of_tex_coords(std::size_t vertices) { return 100 * vertices; }

// RULING for a vertex with NaN, infinity or a number beyond the largest float: a position with such a component becomes
// (0, 0, 0, 0), which is clipped away (2.12); a normal becomes (0, 0, 0); in colours and texture coordinates only the component becomes 0.
void sanitize(Vertex& vertex);
void sanitize(glm::dvec4& values);

class State {
  public:
    explicit State(const StateOptions& options = {});

    // Executes one command. A command with an error changes only errors() (2.5).
    void apply(const Command& command);

    // The first errors, at most kMaxErrorsKept, and the number of all errors.
    const std::vector<GlError>& errors() const { return errors_; }
    std::size_t error_count() const { return error_count_; }
    // The first GL_OUT_OF_MEMORY: the scene exceeds a limit of Twinlight, so no driver should execute it.
    const std::optional<GlError>& exhausted() const { return exhausted_; }

    // Calls `watch` before and after each command of a display list that is executed. The place of such a command is
    // where the list was made.
    void watch_lists(std::function<void(const Command& command, bool is_done)> watch) {
        watch_list_ = std::move(watch);
    }
    // Calls `watch` with each Draw of the window's picture, which is not kept.
    void watch_draws(std::function<void(const Draw&)> watch) { watch_draw_ = std::move(watch); }

    // Notes a call of a function that Twinlight does not know. Its effect is unknown, so it is listed as unsupported
    // for this picture and all later ones.
    void outside(std::string_view function, const Place& place);
    // Another GL context makes or changes an object that this one shares. Each picture that shows it from now on lacks this.
    void made_elsewhere(const SharedObject& object, std::string_view function, const Place& place);

    // The error of the first glBegin, glNewList or push that is still open at the end of a scene; nullopt if there is
    // none.
    std::optional<GlError> unfinished() const;
    // The commands that end them all.
    std::vector<Command> endings() const;

    // The picture so far.
    const std::vector<FrameItem>& items() const { return items_; }
    bool inside_begin() const { return open_.has_value(); }
    // Deletes the picture; later drawing starts a new one.
    void drop_picture();
    // Deletes the items that no later picture can show: those before a Clear of everything that later commands may read.
    void drop_hidden();
    // Returns the picture and starts a new one.
    Frame take_frame();

    // The current values.
    const Attributes& attributes() const { return a_; }
    const LightingState& lighting() const { return a_.lighting; }
    // What LightSource::typed counts.
    const std::vector<TypedLight>& typed_lights() const { return typed_lights_; }
    const RasterState& raster() const { return a_.raster; }
    const glm::dmat4& modelview() const { return modelview_.back().matrix; }
    const glm::dmat4& projection() const { return projection_.back().matrix; }
    const glm::dmat4& texture_matrix() const { return texture_[a_.active_unit].back().matrix; }
    std::size_t matrix_depth(Enum mode) const;  // mode: GL_MODELVIEW, GL_PROJECTION or GL_TEXTURE
    std::size_t attribute_depth() const { return attribute_stack_.size(); }
    Enum render_mode() const { return render_mode_; }
    const VertexArrays& arrays() const { return arrays_; }
    const Lists& lists() const { return lists_; }
    const PixelStore& pixel_store() const { return pixel_store_; }
    const PixelMaps& pixel_maps() const { return pixel_maps_; }
    const Texture& bound_texture(Enum target) const { return *texture_of(unit(), target); }
    // glIsEnabled (6.1.1); nullopt if `cap` is not a capability.
    std::optional<bool> capability(Enum cap) const;
    // glGetLight, glGetMaterial (6.1.3); empty for unknown names.
    std::vector<double> get_light(Enum light, Enum pname) const;
    std::vector<double> get_material(Enum face, Enum pname) const;
    const TextureObjects& textures() const { return textures_; }
    const Framebuffers& framebuffers() const { return framebuffers_; }
    // glCheckFramebufferStatus. `target`: GL_DRAW_FRAMEBUFFER or GL_READ_FRAMEBUFFER.
    Enum framebuffer_status(Enum target) const;

  private:
    struct StackedMatrix {
        glm::dmat4 matrix{1};
        Place pushed;  // the place of glPushMatrix
    };
    using MatrixStack = std::vector<StackedMatrix>;

    // One function for each effect of commands.def, grouped by the file that implements them.
    using Effect = void(const Command&);
    Effect push_attrib, pop_attrib;
    Effect enable, disable;
    Effect client_arrays, array_element, draw_arrays;
    Effect draw_buffer, driver_only_state, driver_only_attribute, driver_only_query;
    Effect raster_pos, window_pos, bitmap, draw_pixels, copy_pixels, pixel_zoom, pixel_transfer, pixel_map;
    Effect stencil_func, stencil_op, stencil_mask, clear_stencil;
    Effect accumulate, clear_accumulation;
    Effect line_stipple, polygon_stipple, logic_op;
    Effect clear_depth, clear_color, clear, scissor, alpha_func, blend_func, blend_color, color_mask, fog,
        blend_equation;
    Effect light, material, light_model, color_material, shade_model, get_light, get_material, specular_model,
        ambient_model, spot_cone, extra_light;
    Effect gen_lists, new_list, end_list, delete_lists, list_base, call_list, call_lists;
    Effect matrix_mode, load_identity, push_matrix, pop_matrix, load_matrix, mult_matrix, rotate, scale, translate,
        frustum, ortho, perspective, ortho_2d, look_at, viewport, clip_plane, load_transpose_matrix,
        mult_transpose_matrix;
    Effect map1, map2, map_grid1, map_grid2, eval_coord, eval_point, eval_mesh;
    Effect build_mipmaps, texture_file;
    Effect front_face, cull_face, polygon_mode, depth_func, depth_mask, flush, depth_range, polygon_offset, line_width,
        point_size, point_parameter, edge_flag, hint;
    Effect render_mode, hit_buffer, is_enabled, query_clip_plane;
    Effect shape, mesh_file, new_quadric, delete_quadric, set_quadric, quadric_shape;
    Effect spectrum, reflectance, illuminant, transfer;
    Effect label;
    Effect begin, end, normal, color, secondary_color, fog_coord, vertex, tex_coord, multi_tex_coord, rect;
    Effect gen_framebuffers, delete_framebuffers, bind_framebuffer, gen_renderbuffers, delete_renderbuffers,
        bind_renderbuffer, renderbuffer_storage, framebuffer_texture, framebuffer_renderbuffer, generate_mipmap,
        read_buffer;
    Effect pixel_store, tex_image, tex_sub_image, copy_tex_image, copy_tex_sub_image;
    Effect bind_texture, active_texture, tex_parameter, tex_env, tex_gen, query_tex_env, query_tex_gen,
        query_tex_parameter, gen_textures, delete_textures, prioritize_textures;
    void set_map(const Command&, bool two);  // glMap1, glMap2
    // The variable of glMapGrid whose values begin at argument `first`; nothing after an error.
    std::optional<MapGrid> map_grid(const Command&, std::size_t first);
    // glMaterial; `reflectance` is null or the spectrum that the colour was computed from.
    void set_material(const Command&, const Spectrum* reflectance);
    void set_light(const Command&, LightSource& source, Enum pname, const std::vector<double>& values);
    // Keeps what glLight was given. Raises GL_OUT_OF_MEMORY and returns false if there is no room.
    bool note_typed(const Command&, LightSource& source, const TypedLight& typed);
    void drop_typed_lights();  // those that no current or saved light has

    void carry_out(const Command& command);
    bool compile(const Command& command);
    std::optional<ArrayVertices> array_vertices(
        const Command& draw);  // raises the error and returns nullopt if it is wrong
    void draw(const Command& command, const ArrayVertices& read);
    // The columns that a Draw with this state has, without values yet.
    static std::vector<VertexColumn> columns_of(const Draw& draw, bool has_secondary_colors);
    // Gives the vertices that have no values in the columns these.
    static void fill_columns(Draw& draw, const VertexValues& values);
    TextureUnit texture_unit(std::size_t number) const;  // of a Draw made now
    void set_combine(const Command& command, Enum pname, double value);
    std::optional<Owner> environment_owner(const Command& command);  // raises GL_INVALID_ENUM for another target
    void send_element(const Command& command, const ArrayVertices& element);  // glArrayElement
    // Whether this many more bytes, or this much more work, stay within the picture's limits; if not, raises
    // GL_OUT_OF_MEMORY.
    bool has_room(const Command& command, std::size_t bytes);
    // Draws share lights that have not changed.
    std::size_t bytes_of_draw() const {
        const LightSources& lights = a_.lighting.lights;
        return sizeof(Draw) + (lights.is_shared() ? 0 : lights.size() * sizeof(LightSource));
    }
    // bytes_of_vertices(), with the texture coordinates of the units that are in use now.
    std::size_t vertex_bytes(Enum mode, std::size_t vertices, std::size_t indices = 0) const;
    bool has_time(const Command& command, double work);
    // The faces that a command of the stencil sets. Raises GL_INVALID_ENUM and returns nullopt for another name.
    std::optional<std::vector<StencilFace*>> stencil_faces(const Command& command, bool names_face);
    std::size_t compile_calls(const Command& command);
    bool walk_calls(const Command& command, const DisplayList& list);
    void execute_list(const Command& command, std::uint32_t name);
    void execute_listed(const ListedCommand& listed);
    void raise_inside(const Command& command);  // for a command between Begin and End
    void raise(GlError error);
    template <class... Values>
    void raise(Enum code, const Command& command, fmt::format_string<Values...> message, Values&&... values) {
        raise(refused(code, command, message, std::forward<Values>(values)...));
    }
    // Whether `value` is one of `allowed`; raises GL_INVALID_ENUM if not.
    bool known(const Command& command, Enum value, std::initializer_list<Enum> allowed);
    LightSource* light_source(const Command& command,
                              Enum light);  // raises GL_INVALID_ENUM and returns null if unknown
    // The values of glLight*, glMaterial*, glFog*, glTexEnv*, ... as real numbers. If they are invalid, raises the
    // error and returns nullopt.
    std::optional<std::vector<double>> parameter_values(const Command& command, Owner owner, Enum pname);
    void set_capability(const Command& command, bool enabled);
    bool known_capability(const Command& command);  // raises GL_INVALID_ENUM if not
    // The texture that a glTex* command may change: no Draw shares it. Raises the error and returns null for a wrong
    // target.
    Texture* writable_texture(const Command& command, Enum target);  // of the active unit
    Texture* writable_texture(const Command& command, const TextureBindings& bindings, Enum target);
    const std::shared_ptr<Texture>& texture_of(const TextureBindings& bindings, Enum target) const;
    std::shared_ptr<const Texture> complete_texture(const TextureBindings& bindings) const;
    std::shared_ptr<const Texture> with_levels(const std::shared_ptr<const Texture>& texture, int first,
                                               int last) const;
    TextureBindings& unit() { return a_.units[a_.active_unit]; }
    const TextureBindings& unit() const { return a_.units[a_.active_unit]; }
    bool check_pixel_type(const Command& command, const PixelSource& source);
    // Whether pixels of this format can be put into an image of a texture. If not, raises the error or notes it.
    bool check_depths(const Command& command, Enum texture, Enum base_format, Enum pixels);
    std::optional<PixelRows> pixels(const Command& command, const PixelSource& source);
    // The memory that the command's pointer points to, or the buffer bound for pixels (2.9). If it has less than `needed`
    // bytes, raises the error and returns nullopt.
    std::optional<std::span<const std::byte>> pixel_memory(const Command& command, std::size_t needed);
    std::shared_ptr<RasterVertex> raster_vertex() const;  // of the current values
    // Adds a Draw of pixels with the raster position's values. `colors`: of each place; none: the raster position's.
    void draw_at_raster_position(const Command& command, WindowPixels pixels, const std::vector<glm::dvec4>& colors);
    void draw_stencils(const Command& command, const PixelSource& source);
    void copy_buffer(const Command& command, CopiedBuffer buffer);
    // 3.6.4, 4.3.3: whether the picture has depths, or stencil values, to draw and to read. If not, raises the error.
    bool has_buffer(const Command& command, CopiedBuffer buffer);
    std::uint8_t transferred_stencil(std::int64_t value) const;
    void generate_mipmaps(Texture& texture, std::size_t face) const;
    // What a command with images in one or two dimensions names. Raises GL_INVALID_ENUM and returns nullopt for a wrong
    // target; for one of a proxy only if not `allows_proxy`.
    std::optional<ImageTarget> image_target(const Command& command, bool allows_proxy = false);
    // Pixels of the picture so far. Raises the error and returns null if there is no room for `count` values.
    std::shared_ptr<const CopiedPixels> copied_pixels(const Command& command, CopiedBuffer buffer,
                                                      const Rectangle& from, double count);
    // The same for all pixels of the rectangle, for a texture.
    std::shared_ptr<const CopiedPixels> take_pixels(const Command& command, CopiedBuffer buffer, const Rectangle& from);
    // Framebuffer objects: framebuffers.cpp.
    struct AttachedImage {
        int width = 0, height = 0;
        Enum format = 0;  // the internal format
    };
    // The picture that is being drawn into the bound object.
    struct OpenObject {
        ObjectPicture picture{};
        bool has_color = false, has_alpha = false, has_depth = false, has_stencil = false;
        int depth_bits = 24;
        bool knows_depths = false;  // they were drawn or cleared
        bool is_lost = false;       // an image that no renderer but the driver has
        bool is_changed = false;
    };
    bool use_framebuffers(const Command& command);
    bool begin_object_picture(const Command& command);
    void end_object_picture(const Command& command);
    void show_in_object(FrameItem item);
    bool draws_color() const;
    bool check_buffer(const Command& command, std::uint32_t framebuffer);
    void detach(Enum type, std::uint32_t name);
    std::vector<Attachment*> attachments(const Command& command);
    std::optional<AttachedImage> attached_image(const Attachment& attachment) const;  // nullopt: it has no pixels
    Enum status_of(const FramebufferObject& object) const;
    std::shared_ptr<const ObjectPicture> whole_picture(const Attachment& attachment, CopiedBuffer buffer) const;
    std::shared_ptr<const Texture> attached_texture(const Command& command, const Attachment& attachment);
    std::shared_ptr<const ObjectPicture> read_picture(const Command& command, CopiedBuffer buffer);
    std::size_t bytes_of_object_pictures() const;
    // Before the first items are deleted: keeps those that textures have copies of.
    void keep_for_copies(std::size_t count);
    std::size_t bytes_of(const FrameItems& items) const;
    std::size_t bytes_of_kept_pictures() const;
    // Whether this many more texels stay within the limits; `replaced` texels are freed. If not, raises
    // GL_OUT_OF_MEMORY.
    bool has_texels(const Command& command, double count, std::size_t replaced = 0);
    bool counts(const Command& command, const char* what);  // n >= 0; if not, raises GL_INVALID_VALUE
    void track_color();                                     // 2.14.3: the material follows the current colour
    void multiply(const Command& c, const glm::dmat4& matrix);
    MatrixStack& stack();
    std::size_t stack_limit() const;
    Draw new_draw(Enum mode, const Place& place);
    // False after GL_OUT_OF_MEMORY.
    bool send_part(const Command& command, ShapePart part, const std::shared_ptr<const std::vector<Surface>>& surfaces);
    void send_evaluated(const Command& command, double u, std::optional<double> v);  // glEvalCoord
    // The vertex on the enabled maps; none if no map of vertices is enabled.
    std::optional<Vertex> evaluated(double u, std::optional<double> v) const;
    Quadric* quadric(
        const Command& command);  // its first argument; raises the error and returns null if it does not exist
    bool can_send(const Command& command);  // whether its quadric can be drawn; if not, raises the error
    void show(FrameItem item);              // adds it to the picture if the render mode is GL_RENDER
    // Notes something unsupported: note_lasting() for this and all later pictures, note_unsupported() only for this
    // one.
    void note_lasting(std::string_view name, const Place& place);
    void note_unsupported(const std::string& name, const Place& place, MissingFrom missing_from = MissingFrom::kFrame);
    // The picture shows an object that contexts may share; notes it if another context made it.
    void show_shared(SharedObject::Kind kind, std::uint32_t name);
    void show_shared_buffers();  // those of the enabled arrays
    // A component of a colour or a normal: integers become [-1,1] or [0,1].
    double to_real(double c, Kind kind) const;

    struct SavedAttributes {
        Attributes attributes;
        Enum mask = 0;
        // The parameters of the textures that are bound in any unit (table 6.16), by target and name.
        std::map<std::pair<Enum, std::uint32_t>, Texture> textures;
        Place pushed;
    };

    StateOptions options_;
    Attributes a_;
    TextureObjects textures_;
    Framebuffers framebuffers_;
    std::optional<OpenObject> object_;
    std::vector<std::weak_ptr<const ObjectPicture>> object_pictures_;
    // Textures of which not all levels are in use, and the levels in use. Holding a texture keeps it unchanged.
    mutable std::map<const Texture*, std::pair<std::shared_ptr<const Texture>, std::shared_ptr<const Texture>>>
        parts_of_textures_;
    PixelStore pixel_store_;
    PixelMaps pixel_maps_{std::vector<double>{0}, {0}, {0}, {0}};
    std::vector<int> stencil_map_{0};                            // GL_PIXEL_MAP_S_TO_S
    std::vector<std::optional<PixelStore>> saved_pixel_stores_;  // by glPushClientAttrib, one per level
    VertexArrays arrays_;
    Lists lists_;
    std::function<void(const Command&, bool)> watch_list_;
    std::function<void(const Draw&)> watch_draw_;
    MatrixStack modelview_{{}}, projection_{{}};
    std::vector<MatrixStack> texture_{kMaxTextureUnits, MatrixStack{{}}};  // one per unit
    std::vector<SavedAttributes> attribute_stack_;
    Enum render_mode_ = kGL_RENDER;                      // 5.2
    bool has_selection_ = false, has_feedback_ = false;  // has a buffer with room
    std::optional<Draw> open_;                           // between Begin and End
    std::uint64_t state_number_;                         // Draw::state_number of the next Draw
    std::size_t open_bytes_ = 0;                         // what it counts in item_bytes_, besides its vertices
    std::map<Enum, EvaluatorMap> maps_;                  // by the target of glMap
    std::map<double, Quadric> quadrics_;                 // by number
    std::map<double, Place> deleted_quadrics_;           // the place of gluDeleteQuadric
    std::vector<FrameItem> items_;
    std::size_t item_bytes_ = 0;  // the approximate size of items_, kept_pictures_ and the newest typed_lights_
    // Pictures that textures may have copies of. What has no copies any more is deleted with the next picture.
    struct KeptPicture {
        std::shared_ptr<const FrameItems> items;
        std::vector<std::weak_ptr<const CopiedPixels>> copies;
        std::size_t bytes = 0;
    };
    std::vector<KeptPicture> kept_pictures_;
    bool copies_pixels_ = false;
    std::vector<TypedLight> typed_lights_{{}};
    std::vector<SceneLabel> labels_;
    double work_ = 0;  // work for this picture so far
    std::vector<Unsupported> unsupported_;
    std::vector<Unsupported> outside_;
    std::map<SharedObject, std::pair<std::string, Place>> elsewhere_;  // the last call of made_elsewhere() for each
    std::vector<GlError> errors_;
    std::size_t error_count_ = 0;
    std::optional<GlError> exhausted_;
};

// Executes all commands of a scene. Throws SceneError with its GL errors, if a glBegin, glNewList or push is still open
// at the end, and if nothing is drawn.
Frame make_frame(const CommandList& commands, const StateOptions& options);
// For a scene whose text has errors: adds the GL errors of the commands that could be read and do not depend on others
// (wrong names and values).
SceneError with_gl_errors(const SceneError& error, const StateOptions& options);
// A whole program's GL errors are notes of its recording: GL ignores the commands that cause them.
Scene make_scene(std::shared_ptr<const CommandList> commands, const StateOptions& options);

}  // namespace twinlight
