// Converts shapes to Draws, one for each part. GLU's quadrics hold the settings of their shapes (GLU 1.3, chapter 6).

#include <stdexcept>

#include "scene/shape/shape.h"
#include "scene/shape/written_out.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

// A shape that is too large exceeds only Twinlight's limits, so it gives GL_OUT_OF_MEMORY.
Enum code_of(const std::invalid_argument& error, Enum otherwise) {
    return dynamic_cast<const ShapeTooLarge*>(&error) != nullptr ? kGL_OUT_OF_MEMORY : otherwise;
}

// What all parts of a shape share; null if there are none.
std::shared_ptr<const std::vector<Surface>> shared(std::vector<Surface> surfaces) {
    return surfaces.empty() ? nullptr : std::make_shared<const std::vector<Surface>>(std::move(surfaces));
}

}  // namespace

void State::shape(const Command& c) {
    try {
        const auto surfaces = shared(shape_surfaces(c));
        for_each_part(c, [&](ShapePart&& part) { return send_part(c, std::move(part), surfaces); });
    } catch (const std::invalid_argument& error) {
        raise(code_of(error, kGL_INVALID_VALUE), c, "{}", error.what());
    }
}

void State::mesh_file(const Command& c) {
    for (const Command& command : mesh_commands(c)) carry_out(command);
}

// Attributes that a part does not send have the current values. Attributes sent between glBegin and glEnd become
// current (2.7).
// RULING: attributes sent by vertex arrays do not; 2.8 leaves this open.
bool State::send_part(const Command& c, ShapePart part, const std::shared_ptr<const std::vector<Surface>>& surfaces) {
    if (!has_time(c, static_cast<double>(part.vertices.size()))) return false;
    const std::size_t bytes = bytes_of_draw() + vertex_bytes(part.mode, part.vertices.size(), part.indices.size());
    if (!has_room(c, bytes)) return false;
    Draw draw = new_draw(part.mode, c.place);
    std::vector<Vertex> vertices;
    vertices.reserve(part.vertices.size());
    const VertexValues before = a_.current;
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
        const ShapeVertex& sent = part.vertices[i];
        if (i >= part.first_normal) a_.current.normal_object = sent.normal_object;
        if (part.sends_tex_coords) a_.current.tex_coord = glm::dvec4(sent.tex_coord, 0, 1);
        Vertex& vertex = vertices.emplace_back(a_.current);
        vertex.position_object = glm::dvec4(sent.position_object, 1);
        vertex.material = 0;
    }
    if (!part.immediate) a_.current = before;
    draw.vertices = std::move(vertices);
    fill_columns(draw, a_.current);
    draw.indices = std::move(part.indices);
    draw.surfaces = surfaces;
    show(std::move(draw));
    return true;
}

void State::new_quadric(const Command& c) {
    quadrics_[c.number(0)] = {};
    deleted_quadrics_.erase(c.number(0));
}

void State::delete_quadric(const Command& c) {
    if (!quadric(c)) return;
    quadrics_.erase(c.number(0));
    deleted_quadrics_[c.number(0)] = c.place;
}

void State::set_quadric(const Command& c) {
    Quadric* q = quadric(c);
    if (q && !set(*q, c))
        raise(kGLU_INVALID_ENUM, c, "{} is given {}; expected {}", c.name(), enum_name(c.enumerant(1)), choices(c.id));
}

void State::quadric_shape(const Command& c) {
    const Quadric* q = lists_.quadric ? lists_.quadric : quadric(c);
    if (!q) return;
    try {
        const auto surfaces = shared(quadric_surfaces(*q, c));
        for (ShapePart& part : quadric_parts(*q, c))
            if (!send_part(c, std::move(part), surfaces)) return;
    } catch (const std::invalid_argument& error) {
        raise(code_of(error, kGLU_INVALID_VALUE), c, "{}", error.what());
    }
}

bool State::can_send(const Command& c) {
    const Quadric* q = quadric(c);
    if (!q) return false;
    try {
        quadric_parts(*q, c);
        return true;
    } catch (const std::invalid_argument& error) {
        raise(code_of(error, kGLU_INVALID_VALUE), c, "{}", error.what());
        return false;
    }
}

Quadric* State::quadric(const Command& c) {
    const auto found = quadrics_.find(c.number(0));
    if (found != quadrics_.end()) return &found->second;
    const auto deleted = deleted_quadrics_.find(c.number(0));
    if (deleted == deleted_quadrics_.end())
        raise(kGL_INVALID_VALUE, c, "{} needs a quadric; create one with gluNewQuadric()", c.name());
    else
        raise(kGL_INVALID_VALUE, c, "{} uses a quadric that gluDeleteQuadric deleted at {}", c.name(),
              deleted->second.str());
    return nullptr;
}

}  // namespace twinlight
