#include "render/programmable/text/rectangles_text.h"

#include <fmt/format.h>

#include "render/programmable/text/shader_pieces.h"

namespace twinlight::programmable {

namespace {

// The ends of the line's visible part come from both vertices, so that they are the same at all corners.
std::string line_corner_text(const Form& form, const std::string& clip_position,
                             const std::vector<std::string>& clip_distances) {
    std::string text = fmt::format(
        "    // A corner of a line's rectangle (section 3.4.2). Only the part of the line in the view volume counts.\n"
        "    vec4 other = {}, other_clip;\n{}"
        "    bool is_first = a_line_corner.x < 0.0;\n"
        "    vec4 from_clip = is_first ? gl_Position : other_clip, to_clip = is_first ? other_clip : gl_Position;\n"
        "    vec2 part = part_in_view(from_clip, to_clip);\n",
        form.position_w ? "a_line_other" : "vec4(a_line_other.xyz, 1.0)",
        with_words(clip_position, {{"gl_Position", "other_clip"}, {"position", "other"}}));
    for (const std::string& own : clip_distances) {
        const std::string other = with_words(own, {{"position", "other"}});
        text += fmt::format("    part = clipped_part(part, is_first ? {0} : {1}, is_first ? {1} : {0});\n", own, other);
    }
    return text + fmt::format(
                      "    vec4 line_ends_window = vec4(in_window(mix(from_clip, to_clip, part.x), u_viewport),\n"
                      "        in_window(mix(from_clip, to_clip, part.y), u_viewport));\n"
                      "    // Behind the eye, the sides would cross: there the rectangle becomes a triangle.\n"
                      "    vec2 beside = gl_Position.w > 0.0 ? {}(line_ends_window, a_line_corner.xy, u_line_width) : "
                      "vec2(0.0);\n"
                      "    gl_Position.xyz += vec3(2.0 * beside / u_viewport.zw, a_line_corner.z) * gl_Position.w;\n"
                      "    if (part.x > part.y) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // nothing is visible\n",
                      form.smooth ? "beside_smooth_line" : "beside_line");
}

}  // namespace

std::string corner_text(const Form& form, const std::string& clip_position,
                        const std::vector<std::string>& clip_distances) {
    if (form.rectangles == Rectangles::kLines) return line_corner_text(form, clip_position, clip_distances);
    std::string text;
    if (form.needs_point_window()) text += "    vec2 point_window = in_window(gl_Position, u_viewport);\n";
    if (form.rectangles == Rectangles::kPoints)
        text +=
            "    gl_Position.xyz += a_point_corner * gl_Position.w;  // a corner of a point's square (section 3.3)\n";
    return text;
}

std::string line_text(const Form& form) {
    std::string text;
    if (form.rectangles == Rectangles::kLines && !form.smooth)
        text += "    if (!is_on_line(v_line_ends_window, gl_FragCoord.xy, u_line_width)) discard;\n";
    if (form.line_stipple)
        text +=
            "    // glLineStipple (section 3.4.2): the fragment's number on its line chooses a bit of the pattern.\n"
            "    int count = max(int(dot(v_line_count, vec3(floor(gl_FragCoord.xy), 1.0))), 0);\n"
            "    if ((u_line_stipple_pattern >> (count / u_line_stipple_factor % 16) & 1) == 0) discard;\n";
    return text;
}

std::string coverage_text(const Form& form, const std::string& size) {
    if (!form.smooth) return "";
    const std::string share = form.rectangles == Rectangles::kLines
                                  ? "line_coverage(v_line_ends_window, u_line_width, floor(gl_FragCoord.xy))"
                                  : fmt::format("point_coverage(v_point_window, {}, floor(gl_FragCoord.xy))", size);
    // Rounding leaves a little where nothing is covered.
    return fmt::format(
        "    // Antialiasing (section 3.11).\n"
        "    float coverage = {};\n"
        "    if (coverage < 1e-5) discard;\n"
        "    color.a *= coverage;\n",
        share);
}

}  // namespace twinlight::programmable
