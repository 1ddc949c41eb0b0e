// What scene.c and window.c have in common: the scene's data and its frames. Needs gl_state.h.
#ifndef SCENE_H
#define SCENE_H

struct image {
    int width, height, depth;
    int first_texel;  // in 4 bytes of scene.bin: red, green, blue, alpha; or a depth as a whole number
};

struct texture {
    GLenum target, min_filter, mag_filter, wrap_s, wrap_t, wrap_r;
    float border_color[4];
    int level_count;
    struct image levels[16];
    int has_depths;
    GLenum compare_func;  // GL_TEXTURE_COMPARE_FUNC; 0: depths are not compared
};

struct attribute {
    const char* name;
    int floats;  // of it that the draw uses
    int room;    // in floats
};

// Points, lines or triangles. The places are in scene.bin, counted in 4 bytes.
struct mesh {
    GLenum mode;
    const struct attribute* layout;  // ends with a name of NULL
    int first_vertex, first_index, index_count;
};

struct frame {
    int number;          // in the recording
    void (*draw)(void);  // frames that differ only in numbers and meshes have one function
    int index;           // among these
    int first_value;     // in 4 bytes of scene.bin: frame_values
};

// ---- window.c ----

// For the frame that is being drawn: its numbers, and its place among the frames of one function.
extern const float* frame_values;
extern int frame_index;

void load_texture(int texture, struct texture description);
void use_texture(GLenum target, int texture, float lod_bias);
// The modelview matrix becomes the camera's: a movement of eye coordinates. Without a turn it is the identity.
void camera(void);
// glLight with GL_POSITION and glEnable; keys and --light change them.
void place_light(GLenum light, float x, float y, float z, float w);
void switch_light(GLenum light, int is_on);
// What GL's state lacks, for the shaders of a kind.
void set_uniform(int kind, const char* uniform, float value);
void draw(struct mesh mesh);

// ---- scene.c ----

extern const int scene_width, scene_height;
extern const int scene_gl_version[2], scene_has_core_profile;
extern const int scene_texture_count;
extern const float scene_middle[3];  // in eye coordinates; --turn turns around it
extern const struct frame scene_frames[];
extern const int scene_frame_count;
void load_scene(void);

#endif
