#include "app/demo/overlays.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "base/text/translation.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"

namespace twinlight::demo {
namespace {

using session::DrawOverlay;
using session::OverlayPicture;
using session::OverlayVertex;
using session::Wireframe;

constexpr float kPointSize = 7, kHaloWidth = 2.5F, kLineWidth = 1;
constexpr float kHidden = 0.16F;                      // alpha of what faces hide
constexpr float kOffsetFactor = 1, kOffsetUnits = 4;  // faces lie so much behind what is drawn on them (3.5.5)

// The depth range and viewport of a Draw.
void use_viewport(const DrawOverlay& draw) {
    glViewport(draw.viewport.x, draw.viewport.y, draw.viewport.width, draw.viewport.height);
    glScissor(draw.viewport.x, draw.viewport.y, draw.viewport.width, draw.viewport.height);
    glDepthRange(draw.depth_near, draw.depth_far);
}

void draw_faces(const DrawOverlay& draw) {
    if (draw.faces_clip.empty()) return;
    glVertexPointer(4, GL_FLOAT, 0, draw.faces_clip.data());
    glEdgeFlagPointer(0, draw.edges.data());
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(draw.faces_clip.size()));
}

void draw_vertices(GLenum mode, const std::vector<OverlayVertex>& vertices) {
    if (vertices.empty()) return;
    glEnableClientState(GL_COLOR_ARRAY);
    const auto* first = reinterpret_cast<const std::byte*>(vertices.data());
    glVertexPointer(4, GL_FLOAT, sizeof(OverlayVertex), first + offsetof(OverlayVertex, position_clip));
    glColorPointer(4, GL_FLOAT, sizeof(OverlayVertex), first + offsetof(OverlayVertex, color));
    glDrawArrays(mode, 0, static_cast<GLsizei>(vertices.size()));
    glDisableClientState(GL_COLOR_ARRAY);
}

void draw_texture(unsigned texture) {
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        glTexCoord2i(x, y);
        glVertex2i(2 * x - 1, 2 * y - 1);
    }
    glEnd();
    glBindTexture(GL_TEXTURE_2D, 0);
    glDisable(GL_TEXTURE_2D);
}

void use_smooth_lines() {
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_POINT_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glLineWidth(kLineWidth);
    glPointSize(kPointSize);
}

// The depths of the faces. Leaves a depth test for what lies on them.
void draw_depths(const OverlayPicture& overlays) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    for (const DrawOverlay& draw : overlays.draws) {
        if (!draw.hides || draw.faces_clip.empty()) continue;
        use_viewport(draw);
        glVertexPointer(4, GL_FLOAT, 0, draw.faces_clip.data());
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(draw.faces_clip.size()));
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
}

// Stripes where alpha exceeds 0.5.
void draw_brightness(const OverlayPicture& overlays) {
    std::array<GLubyte, 128> stripes{};  // 32 rows of 32 bits, leftmost first
    for (unsigned y = 0; y < 32; ++y)
        for (unsigned x = 0; x < 32; ++x)
            if ((x + y) % 8 < 4) stripes[(32 * y + x) / 8] |= static_cast<GLubyte>(0x80U >> (x % 8));
    glPolygonStipple(stripes.data());
    glEnable(GL_POLYGON_STIPPLE);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5F);
    glBlendColor(0, 0, 0, 0.85F);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    for (const DrawOverlay& draw : overlays.draws) {
        use_viewport(draw);
        draw_vertices(GL_TRIANGLES, draw.brightness);
        draw_vertices(GL_POINTS, draw.point_brightness);
    }
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_ALPHA_TEST);
    glDisable(GL_POLYGON_STIPPLE);
}

// A dark line under a light one is visible on every picture.
void draw_wires(const OverlayPicture& overlays) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    const bool alone = overlays.wireframe == Wireframe::kAlone;
    const auto pass = [&](float width, float grey, float alpha) {
        glLineWidth(width);
        glColor4f(grey, grey, grey, alpha);
        for (const DrawOverlay& draw : overlays.draws) {
            use_viewport(draw);
            draw_faces(draw);
        }
    };
    if (alone) {
        glDepthFunc(GL_GREATER);
        pass(kLineWidth, 1, kHidden);
        glDepthFunc(GL_LEQUAL);
        pass(kLineWidth, 0.95F, 1);
    } else {
        pass(kHaloWidth, 0, 0.22F);
        pass(kLineWidth, 1, 0.6F);
    }
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

bool checkbox(const char* label, bool& value, const char* help, ImU32 color = 0) {
    if (color != 0) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float size = ImGui::GetFontSize() * 0.7F;
        const float y = at.y + (ImGui::GetFrameHeight() - size) / 2;
        ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, {at.x + size, y + size}, color, 2);
    }
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetFontSize() * 1.1F);
    const bool changed = ImGui::Checkbox(tr(label), &value);
    ImGui::Indent(ImGui::GetFontSize() * 1.1F + ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
    dim_text(tr(help));
    ImGui::Unindent(ImGui::GetFontSize() * 1.1F + ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::Spacing();
    return changed;
}

}  // namespace

void draw_overlays(const OverlayPicture& overlays, unsigned texture, int width, int height) {
    const fixed::InitialState initial(width, height);
    if (overlays.wireframe == Wireframe::kAlone) {
        const glm::vec4& background = overlays.background;
        glClearColor(background.r, background.g, background.b, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    } else {
        glClear(GL_DEPTH_BUFFER_BIT);
        draw_texture(texture);
    }
    glEnable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST);
    glEnableClientState(GL_VERTEX_ARRAY);
    use_smooth_lines();
    if (std::ranges::any_of(overlays.draws, [](const DrawOverlay& draw) { return !draw.tints.empty(); })) {
        draw_depths(overlays);
        for (const DrawOverlay& draw : overlays.draws) {
            use_viewport(draw);
            draw_vertices(GL_TRIANGLES, draw.tints);
        }
        glDisable(GL_SCISSOR_TEST);
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
    }
    // Parts of faces and lines lie slightly before them.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(kOffsetFactor, kOffsetUnits);
    draw_depths(overlays);
    glDisable(GL_POLYGON_OFFSET_FILL);
    for (const DrawOverlay& draw : overlays.draws) {
        use_viewport(draw);
        draw_vertices(GL_TRIANGLES, draw.marks);
    }
    draw_brightness(overlays);
    if (overlays.wireframe != Wireframe::kOff) {
        glEnableClientState(GL_EDGE_FLAG_ARRAY);
        draw_wires(overlays);
        glDisableClientState(GL_EDGE_FLAG_ARRAY);
    }
    glLineWidth(kLineWidth);
    for (const DrawOverlay& draw : overlays.draws) {
        use_viewport(draw);
        draw_vertices(GL_LINES, draw.lines);
        draw_vertices(GL_POINTS, draw.points);
    }
    glDisableClientState(GL_VERTEX_ARRAY);
}

void draw_lines(const std::vector<OverlayVertex>& lines, int width, int height) {
    const fixed::InitialState initial(width, height);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    use_smooth_lines();
    glLineWidth(1.6F);
    glEnableClientState(GL_VERTEX_ARRAY);
    std::vector<OverlayVertex> hidden = lines;
    for (OverlayVertex& vertex : hidden) vertex.color.a *= 2 * kHidden;
    glDepthFunc(GL_GREATER);
    draw_vertices(GL_LINES, hidden);
    glDepthFunc(GL_LEQUAL);
    draw_vertices(GL_LINES, lines);
    glDisableClientState(GL_VERTEX_ARRAY);
}

void show_scene_labels(const std::vector<SceneLabel>& labels, const Rectangle& picture) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float margin = at_scale(4);
    std::vector<ImVec4> taken;  // left, top, right, bottom
    for (const SceneLabel& label : labels) {
        const std::string text = tr(std::string_view(label.text));
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        // Centred at its point, but inside the picture.
        const auto start = [&](double at, int from, int length, float text_length) {
            const float first = static_cast<float>(from) + margin,
                        last = static_cast<float>(from + length) - margin - text_length;
            const float wanted = static_cast<float>(from + at * length) - text_length / 2;
            return std::round(std::max(first, std::min(last, wanted)));
        };
        const ImVec2 at{start(label.place_picture.x, picture.x, picture.width, size.x),
                        start(1 - label.place_picture.y, picture.y, picture.height, size.y)};
        const ImVec4 box{at.x - margin, at.y, at.x + size.x + margin, at.y + size.y};
        const auto overlaps = [&](const ImVec4& other) {
            return box.x < other.z && other.x < box.z && box.y < other.w && other.y < box.w;
        };
        if (size.x + 2 * margin > static_cast<float>(picture.width) || std::ranges::any_of(taken, overlaps)) continue;
        taken.push_back(box);
        constexpr std::array<std::array<float, 2>, 8> kAround = {
            {{-1, -1}, {0, -1.5F}, {1, -1}, {-1.5F, 0}, {1.5F, 0}, {-1, 1}, {0, 1.5F}, {1, 1}}};
        for (const auto& [x, y] : kAround)
            draw.AddText({at.x + at_scale(x), at.y + at_scale(y)}, IM_COL32(0, 0, 0, 150), text.c_str());
        draw.AddText(at, IM_COL32_WHITE, text.c_str());
    }
}

void show_labels(const OverlayPicture& overlays, const Rectangle& picture) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const ImVec2 from = corner(picture);
    draw.PushClipRect(from, {from.x + static_cast<float>(picture.width), from.y + static_cast<float>(picture.height)},
                      true);
    for (const session::Label& label : overlays.labels) {
        const ImVec2 size = ImGui::CalcTextSize(label.text.c_str());
        const ImVec2 at{from.x + static_cast<float>(label.place.x) - size.x / 2,
                        from.y + static_cast<float>(label.place.y) - size.y / 2};
        draw.AddRectFilled({at.x - 6, at.y - 1}, {at.x + size.x + 6, at.y + size.y + 1}, IM_COL32(18, 20, 24, 205), 4);
        draw.AddText(at, label.is_warning ? kBad : kText, label.text.c_str());
    }
    draw.PopClipRect();
}

std::optional<PaneJob> OverlaidPicture::next_job(const session::Session& session, const Look& look, int version,
                                                 std::function<void(Texture&)> upload) {
    const Wanted wanted{session.overlays, session.revision, version, look.shading, look.lecture_variants};
    if (wanted_ == wanted) return {};
    Wanted same_lines = wanted;
    same_lines.version = wanted_.version;
    if (same_lines != wanted_) {
        PlanOptions options;
        static_cast<Look&>(options) = look;
        made_ = std::make_shared<const OverlayPicture>(overlays_of(session.scene.frame, session.overlays, options));
    }
    wanted_ = wanted;
    PaneJob job;
    job.size = {session.width, session.height};
    job.overlays = made_;
    job.draw = [overlays = made_, size = job.size, upload = std::move(upload)](Renderers&) {
        Texture picture(GL_NEAREST);
        upload(picture);
        draw_overlays(*overlays, picture.name(), size.width, size.height);
    };
    return job;
}

void OverlaidPicture::take(const PanePicture& picture) {
    shown_ = picture.job.overlays;
    texture_.upload(picture.rgba, picture.job.size.width, picture.job.size.height);
}

void OverlaidPicture::forget() {
    wanted_ = {};
    made_.reset();
    shown_.reset();
}

void overlays_panel(session::Session& session) {
    session::Overlays& overlays = session.overlays;
    bold_text(tr("Wireframe"));
    constexpr std::array<const char*, 3> kWireframes = {"Off", "Over the picture", "Lines only"};
    for (std::size_t i = 0; i < kWireframes.size(); ++i) {
        const char* const label = tr(kWireframes[i]);
        if (i > 0) same_line_for(label);
        if (ImGui::RadioButton(label, overlays.wireframe == static_cast<Wireframe>(i)))
            overlays.wireframe = static_cast<Wireframe>(i);
    }
    dim_text(tr("The borders of all primitives, unlit. Key m."));
    ImGui::Spacing();
    ImGui::Spacing();
    bold_text(tr("Marks"));
    checkbox(
        "Normals", overlays.normals,
        "Green: the length is 1, as lighting needs. Red: it is not, so the surface is too dark or too bright. Key n.",
        IM_COL32(89, 230, 128, 255));
    checkbox("Provoking vertices", overlays.provoking_vertices,
             "The corner of each primitive whose colour GL_FLAT takes for all of it (2.14.7).",
             IM_COL32(255, 191, 51, 255));
    checkbox("Back faces", overlays.back_faces,
             "Faces that turn their back to the eye. GL_LIGHT_MODEL_TWO_SIDE lights them with reversed normals.",
             IM_COL32(64, 128, 255, 255));
    checkbox("Channels above 1", overlays.above_one,
             "Where a channel exceeds 1 before it is clamped (2.14.6). At the vertices; for lighting per pixel also "
             "between them.",
             IM_COL32(255, 0, 191, 255));
    checkbox("Lights that count", overlays.kept_lights,
             "The lights that can change a pixel of each object. The shaders leave out the others.");
    if (!session.scene.frame.labels.empty())
        checkbox("The scene's labels", session.labels_shown, "Its texts: #pragma twinlight label(x, y, z, \"text\").");
}

}  // namespace twinlight::demo
