// What scene.c calls, and what it defines. The functions set GL's old state as uniforms of the kind in use.
#ifndef LOADER_H
#define LOADER_H

#define GL_GLEXT_PROTOTYPES
#include <GL/freeglut.h>

struct attribute {
    const char* name;
    int floats;
};

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

struct material {
    float emission[4], ambient[4], diffuse[4], specular[4], shininess;
};

struct light {
    float ambient[4], diffuse[4], specular[4];
    float position[4], spot_direction[3];  // in eye coordinates
    float spot_exponent, spot_cutoff;      // degrees
    float attenuation[3];                  // constant, linear, quadratic
};

// ---- loader.c ----

void load_kind(int kind, int attribute_count, const struct attribute* attributes);  // kindN.vert and kindN.frag
void load_texture(int texture, struct texture description);

void use_kind(int kind);
void matrices(const float* model_view, const float* projection);  // column by column
void light(int number, struct light light);
void light_model_ambient(const float* color);
void front_material(struct material material);
void back_material(struct material material);
void fog(const float* color, float density, float start, float end);
void clip_plane(int number, const float* plane);  // in eye coordinates
void use_texture(GLenum target, int texture, float lod_bias);
void texture_matrix(const float* matrix);
void texture_env_color(const float* color);
void object_plane(const char* uniform, const float* plane);  // of glTexGen, in object coordinates
void eye_plane(const char* uniform, const float* plane);     // of glTexGen, in eye coordinates
void number(const char* uniform, float value);
// Vertices and indices lie in scene.bin, counted in 4 bytes.
void draw(GLenum mode, int first_vertex, int first_index, int index_count);

// ---- scene.c ----

extern const int scene_width, scene_height;
extern const int scene_gl_version[2], scene_has_core_profile;
extern const int scene_kind_count, scene_texture_count;
extern const float scene_middle[3];  // in eye coordinates; --turn turns around it
void load_scene(void);
void draw_scene(void);

#endif
