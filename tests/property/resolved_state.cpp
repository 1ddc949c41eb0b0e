#include "resolved_state.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>
#include <vector>

namespace twinlight {
namespace {

using Id = CommandId;

class Writer {
  public:
    explicit Writer(const Draw& draw) : draw_(draw) {}

    std::shared_ptr<const CommandList> build() {
        const LightingState& lighting = draw_.lighting;
        add(Id::glMatrixMode, {kGL_PROJECTION});
        add(Id::glLoadMatrixf, columns(draw_.clip_from_eye));
        add(Id::glMatrixMode, {kGL_MODELVIEW});
        for (std::size_t i = 0; i < kMaxLights; ++i)
            if (lighting.lights[i].enabled) light(kGL_LIGHT0 + static_cast<double>(i), lighting.lights[i]);
        add(Id::glLoadMatrixf, columns(draw_.eye_from_object));

        const LightModel& model = lighting.light_model;
        add(Id::glLightModelfv, with({kGL_LIGHT_MODEL_AMBIENT}, model.ambient));
        add(Id::glLightModelf, {kGL_LIGHT_MODEL_LOCAL_VIEWER, model.local_viewer ? 1.0 : 0.0});
        add(Id::glLightModelf, {kGL_LIGHT_MODEL_TWO_SIDE, model.two_side ? 1.0 : 0.0});
        add(Id::glLightModelf, {kGL_LIGHT_MODEL_COLOR_CONTROL, static_cast<double>(model.color_control)});
        if (lighting.normalize) add(Id::glEnable, {kGL_NORMALIZE});
        if (lighting.rescale_normal) add(Id::glEnable, {kGL_RESCALE_NORMAL});
        material({lighting.front, lighting.back}, nullptr);
        const ColorMaterial& tracking = lighting.color_material;
        add(Id::glColorMaterial, {static_cast<double>(tracking.face), static_cast<double>(tracking.mode)});
        if (tracking.enabled) add(Id::glEnable, {kGL_COLOR_MATERIAL});
        add(Id::glEnable, {kGL_LIGHTING});
        add(Id::glFrontFace, {static_cast<double>(draw_.raster.front_face)});
        add(Id::glBegin, {kGL_TRIANGLES});
        for (std::size_t i = 0; i < 3; ++i) vertex(draw_.vertices[draw_.index(i)], i == 0);
        add(Id::glEnd);
        return std::make_shared<const CommandList>("resolved", std::move(commands_));
    }

  private:
    void add(Id id, std::vector<double> arguments = {}) {
        const std::vector<Parameter>& parameters = signature(id).parameters;
        if (!parameters.empty() && parameters.back().kind == Kind::kFloat)
            for (double& value : arguments) value = static_cast<double>(static_cast<float>(value));
        commands_.push_back({id, std::move(arguments), {}});
    }
    template <class Vector>
    static std::vector<double> with(std::vector<double> head, const Vector& v) {
        for (int i = 0; i < Vector::length(); ++i) head.push_back(v[i]);
        return head;
    }
    static std::vector<double> columns(const glm::dmat4& m) {
        std::vector<double> values;
        for (int i = 0; i < 4; ++i) values = with(std::move(values), m[i]);
        return values;
    }

    void light(double l, const LightSource& light) {
        add(Id::glLightfv, with({l, kGL_AMBIENT}, light.ambient));
        add(Id::glLightfv, with({l, kGL_DIFFUSE}, light.diffuse));
        add(Id::glLightfv, with({l, kGL_SPECULAR}, light.specular));
        add(Id::glLightfv, with({l, kGL_POSITION}, light.position_eye));
        add(Id::glLightfv, with({l, kGL_SPOT_DIRECTION}, light.spot_direction_eye));
        add(Id::glLightf, {l, kGL_SPOT_EXPONENT, light.spot_exponent});
        add(Id::glLightf, {l, kGL_SPOT_CUTOFF, light.spot_cutoff_deg});
        add(Id::glLightf, {l, kGL_CONSTANT_ATTENUATION, light.constant_attenuation});
        add(Id::glLightf, {l, kGL_LINEAR_ATTENUATION, light.linear_attenuation});
        add(Id::glLightf, {l, kGL_QUADRATIC_ATTENUATION, light.quadratic_attenuation});
        add(Id::glEnable, {l});
    }

    // The parameters that differ from the previous materials; all of them if there are none.
    void material(const Materials& now, const Materials* before) {
        const auto color = [&](Enum pname, glm::dvec4 Material::*of) {
            if (before && now.front.*of == before->front.*of && now.back.*of == before->back.*of) return;
            add(Id::glMaterialfv, with({kGL_FRONT, static_cast<double>(pname)}, now.front.*of));
            add(Id::glMaterialfv, with({kGL_BACK, static_cast<double>(pname)}, now.back.*of));
        };
        color(kGL_AMBIENT, &Material::ambient);
        color(kGL_DIFFUSE, &Material::diffuse);
        color(kGL_SPECULAR, &Material::specular);
        color(kGL_EMISSION, &Material::emission);
        if (before && now.front.shininess == before->front.shininess && now.back.shininess == before->back.shininess)
            return;
        add(Id::glMaterialf, {kGL_FRONT, kGL_SHININESS, now.front.shininess});
        add(Id::glMaterialf, {kGL_BACK, kGL_SHININESS, now.back.shininess});
    }

    void vertex(const Vertex& v, bool is_first) {
        // Every vertex sets the attributes that any vertex sets.
        if (!draw_.materials.empty()) {
            const Materials& now = draw_.materials[v.material];
            for (const Materials& other : draw_.materials)
                if (is_first) material(now, &other);
            if (!is_first) material(now, before_);
            before_ = &now;
        }
        add(Id::glColor4f, with({}, v.color));
        add(Id::glNormal3f, with({}, v.normal_object));
        add(Id::glVertex4f, with({}, v.position_object));
    }

    const Draw& draw_;
    const Materials* before_ = nullptr;
    std::vector<Command> commands_;
};

}  // namespace

std::shared_ptr<const CommandList> resolved(const Draw& draw) { return Writer(draw).build(); }

Draw with_modelview(Draw draw, const glm::dmat4& eye_from_object) {
    const glm::dmat4 moved = glm::inverse(eye_from_object) * draw.eye_from_object;
    for (Vertex& vertex : draw.vertices.edit()) vertex.position_object = moved * vertex.position_object;
    draw.eye_from_object = eye_from_object;
    return draw;
}

std::string_view name_of(ModelviewKind kind) {
    switch (kind) {
        case ModelviewKind::kAny: return "as the state has it";
        case ModelviewKind::kIdentity: return "the identity";
        case ModelviewKind::kTranslation: return "a translation";
        case ModelviewKind::kRotation: return "a rotation and a translation";
        case ModelviewKind::kRotation2d: return "a rotation about z";
        case ModelviewKind::kScale2d: return "a scale in x and y";
        case ModelviewKind::kUniformScale: return "a uniform scale";
        case ModelviewKind::kScale: return "a scale";
        case ModelviewKind::kSimilarity: return "a rotation and a uniform scale";
        case ModelviewKind::kShear: return "a shear";
        case ModelviewKind::kProjective: return "a projection";
    }
    return "";
}

glm::dmat4 modelview_of(ModelviewKind kind, const Draw& draw, fuzz::Random& random) {
    // The 128th power of a longer normal exceeds the range of floats.
    const auto some = [&] { return random.uniform(0.75, 1.4); };
    const glm::dmat4 one(1), moved = glm::translate(one, {some(), -some(), some()});
    const auto rotated = [&](const glm::dmat4& m) {
        return glm::rotate(m, random.uniform(-3, 3), glm::normalize(glm::dvec3(some(), -some(), some())));
    };
    switch (kind) {
        case ModelviewKind::kAny: return draw.eye_from_object;
        case ModelviewKind::kIdentity: return one;
        case ModelviewKind::kTranslation: return moved;
        case ModelviewKind::kRotation: return rotated(moved);
        case ModelviewKind::kRotation2d: return glm::rotate(one, random.uniform(-3, 3), {0, 0, 1});
        case ModelviewKind::kScale2d: return glm::scale(one, {some(), some(), 1});
        case ModelviewKind::kUniformScale: return glm::scale(moved, glm::dvec3(some()));
        case ModelviewKind::kScale: return glm::scale(moved, {some(), some(), some()});
        case ModelviewKind::kSimilarity: return glm::scale(rotated(moved), glm::dvec3(some()));
        case ModelviewKind::kShear: {
            glm::dmat4 m = rotated(moved);
            m[1][0] += 0.3 * some();
            return m;
        }
        case ModelviewKind::kProjective: {  // w of the vertices in eye coordinates stays what it was
            glm::dmat4 m = rotated(moved);
            m[0][3] = 0.05 * some();
            return m;
        }
    }
    return one;
}

}  // namespace twinlight
