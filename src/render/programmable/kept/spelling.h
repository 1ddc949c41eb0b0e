// How values and calls of the exported scene are written: in C, or in JavaScript for WebGL.
#pragma once

#include <cstdint>
#include <string>

#include "render/programmable/draw_values.h"
#include "scene/state/frame.h"

namespace twinlight::programmable {

// A scene's name or place, for comments and HTML.
std::string printable(std::string text);

enum class Language : std::uint8_t { kC, kJavaScript };

class Spelling {
  public:
    explicit Spelling(Language language) : is_c_(language == Language::kC) {}

    bool is_c() const { return is_c_; }
    // Of a statement in C: "glEnable(GL_BLEND);" or "gl.enable(gl.BLEND);".
    std::string statement(const std::string& c) const;
    std::string number(double x) const;
    std::string floats(const glm::dvec4& v) const;  // an array
    std::string floats(const glm::dmat4& m) const;
    std::string material(const Material& m) const;
    std::string light(const LightSource& light) const;
    // The body of a struct or of an object, and a member in it.
    std::string structure(const std::string& type, const std::string& members) const;
    std::string member(const char* name, const std::string& value) const;
    std::string list(const std::string& values) const;  // inside a structure: "{1, 2}" or "[1, 2]"

    // "1, 2, 3"
    template <class Vector>
    std::string numbers(const Vector& v) const {
        std::string text;
        for (int i = 0; i < Vector::length(); ++i) text += (i == 0 ? "" : ", ") + number(v[i]);
        return text;
    }

  private:
    bool is_c_;
};

}  // namespace twinlight::programmable
