#include "opponents.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <stdexcept>

#include "base/image/file.h"
#include "render/context/gl.h"
#include "render/programmable/uploaded_mesh.h"
#include "render/stages/fixed_stages.h"
#include "render/stages/textures.h"

namespace twinlight::bench {
namespace {

glm::vec3 rgb(const glm::dvec4& c) { return glm::vec3(c); }

GLuint compiled(GLenum type, const std::string& file, bool textured) {
    const std::string source = std::string(textured ? "#version 130\n#define TEXTURED\n" : "#version 130\n") +
                               read_file("tests/bench/shaders/" + file);
    const char* text = source.c_str();
    const GLuint shader = glCreateShader(type);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint ok = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    std::string log(1000, '\0');
    if (!ok) glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    if (!ok) throw std::runtime_error(fmt::format("the driver refuses {}: {}", file, log));
    return shader;
}

// A program that serves every scene, with one scene's numbers.
class Opponent : public Program {
  public:
    Opponent(const std::string& fragment_file, const Draw& draw)
        : draw_(draw), mesh_(draw, all_attributes(), {}, glm::dvec3(0)), program_(glCreateProgram()) {
        glAttachShader(program_, compiled(GL_VERTEX_SHADER, "uber_vertex.glsl", false));
        glAttachShader(program_, compiled(GL_FRAGMENT_SHADER, fragment_file, draw.texture.texture != nullptr));
        glBindAttribLocation(program_, 0, "a_position");
        glBindAttribLocation(program_, 1, "a_normal");
        glBindAttribLocation(program_, 2, "a_tex_coord");
        glLinkProgram(program_);
        glUseProgram(program_);
        const glm::mat4 clip_from_object(draw.clip_from_eye * draw.eye_from_object), eye(draw.eye_from_object);
        const glm::mat3 normals(glm::transpose(glm::inverse(glm::dmat3(draw.eye_from_object))));
        glUniformMatrix4fv(at("u_clip_from_object"), 1, GL_FALSE, &clip_from_object[0][0]);
        glUniformMatrix4fv(at("u_eye_from_object"), 1, GL_FALSE, &eye[0][0]);
        glUniformMatrix3fv(at("u_eye_from_object_normal"), 1, GL_FALSE, &normals[0][0]);
        glUseProgram(0);
    }
    ~Opponent() override { glDeleteProgram(program_); }
    Opponent(const Opponent&) = delete;
    Opponent& operator=(const Opponent&) = delete;

    void draw() override {
        const FixedStages stages;
        stages.clear({.color = true, .depth = true, .clear_color = glm::dvec4(0), .clear_depth = 1});
        stages.set(draw_.raster, draw_.fragment);
        if (draw_.texture.texture) textures_.bind(draw_.texture);
        glUseProgram(program_);
        mesh_.draw();
    }

  protected:
    GLint at(const std::string& name) const { return glGetUniformLocation(program_, name.c_str()); }
    void set(const std::string& name, const glm::vec3& v) const { glUniform3fv(at(name), 1, &v[0]); }
    void set(const std::string& name, double value) const { glUniform1f(at(name), static_cast<float>(value)); }
    void set(const std::string& name, int value) const { glUniform1i(at(name), value); }
    unsigned program() const { return program_; }

  private:
    static EffectSet all_attributes() {
        EffectSet effects;
        effects.lighting = true;
        effects.lights = {{.directional = true, .diffuse = true}};
        effects.texture.environment = TextureEnvironment::kModulate;
        return effects;
    }

    Draw draw_;
    programmable::UploadedMesh mesh_;
    Textures textures_{Clamping::kShader};
    unsigned program_;
};

bool is_spot(const LightSource& light) { return light.spot_cutoff_deg != 180; }
double cutoff_cosine(const LightSource& light) { return std::cos(light.spot_cutoff_deg * std::numbers::pi / 180); }
glm::dvec3 attenuation(const LightSource& light) {
    return {light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation};
}

class Uber : public Opponent {
  public:
    explicit Uber(const Draw& draw) : Opponent("uber_fragment.glsl", draw) {
        const LightingState& lighting = draw.lighting;
        glUseProgram(program());
        int count = 0;
        for (const LightSource& light : lighting.lights)
            if (light.enabled) set_light(count++, light);
        set("u_light_count", count);
        set("u_two_side", lighting.light_model.two_side ? 1 : 0);
        const bool local = lighting.light_model.local_viewer;
        glUniform4f(at("u_viewer"), 0, 0, local ? 0 : 1, local ? 1 : 0);
        for (int face = 0; face < 2; ++face) {
            const Material& material = face == 0 ? lighting.front : lighting.back;
            const auto element = [face](const char* name) { return fmt::format("{}[{}]", name, face); };
            set(element("u_base"), rgb(material.emission + material.ambient * lighting.light_model.ambient));
            set(element("u_material_diffuse"), rgb(material.diffuse));
            set(element("u_material_specular"), rgb(material.specular));
            set(element("u_shininess"), material.shininess);
        }
        glUseProgram(0);
    }

  private:
    void set_light(int i, const LightSource& light) const {
        const auto element = [i](const char* name) { return fmt::format("{}[{}]", name, i); };
        const glm::dvec3 position(light.position_eye);
        const bool directional = light.position_eye.w == 0;
        const glm::vec4 place(directional ? glm::normalize(position) : position / light.position_eye.w,
                              directional ? 0 : 1);
        glUniform4fv(at(element("u_light_position_eye")), 1, &place[0]);
        set(element("u_light_diffuse"), rgb(light.diffuse));
        set(element("u_light_specular"), rgb(light.specular));
        set(element("u_attenuation"), directional ? glm::dvec3(1, 0, 0) : attenuation(light));
        set(element("u_spot_direction_eye"), glm::normalize(light.spot_direction_eye));
        glUniform2f(at(element("u_spot")), static_cast<float>(is_spot(light) ? cutoff_cosine(light) : -2),
                    static_cast<float>(is_spot(light) ? light.spot_exponent : 0));
    }
};

class FlagUber : public Opponent {
  public:
    explicit FlagUber(const Draw& draw) : Opponent("flag_uber_fragment.glsl", draw) {
        const LightingState& lighting = draw.lighting;
        glUseProgram(program());
        for (int i = 0; i < kMaxLights; ++i) {
            const LightSource& light = lighting.lights[static_cast<std::size_t>(i)];
            const auto element = [i](const char* name) { return fmt::format("u_light[{}].{}", i, name); };
            const glm::vec4 position(light.position_eye);
            set(element("enabled"), light.enabled ? 1 : 0);
            glUniform4fv(at(element("position_eye")), 1, &position[0]);
            set(element("ambient"), rgb(light.ambient));
            set(element("diffuse"), rgb(light.diffuse));
            set(element("specular"), rgb(light.specular));
            set(element("attenuation"), attenuation(light));
            set(element("spot_direction_eye"), light.spot_direction_eye);
            set(element("spot_cutoff_cosine"), is_spot(light) ? cutoff_cosine(light) : -1);
            set(element("spot_exponent"), light.spot_exponent);
        }
        for (const auto& [name, material] :
             {std::pair("u_front.", lighting.front), std::pair("u_back.", lighting.back)}) {
            const std::string of = name;
            set(of + "emission", rgb(material.emission));
            set(of + "ambient", rgb(material.ambient));
            set(of + "diffuse", rgb(material.diffuse));
            set(of + "specular", rgb(material.specular));
            set(of + "shininess", material.shininess);
        }
        set("u_scene_ambient", rgb(lighting.light_model.ambient));
        set("u_local_viewer", lighting.light_model.local_viewer ? 1 : 0);
        set("u_two_side", lighting.light_model.two_side ? 1 : 0);
        set("u_normalize", 1);
        glUseProgram(0);
    }
};

}  // namespace

std::unique_ptr<Program> make_uber(const Draw& draw) { return std::make_unique<Uber>(draw); }
std::unique_ptr<Program> make_flag_uber(const Draw& draw) { return std::make_unique<FlagUber>(draw); }

}  // namespace twinlight::bench
