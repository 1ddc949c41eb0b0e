#include "app/demo/cut_texts.h"

#include <algorithm>
#include <cstddef>

namespace twinlight::demo {
namespace {

// A letter is two triangles with the corners a, b, c and a, c, d, from the upper left one clockwise, and a part of a texture that is
// not turned; pictures are.
bool is_letter(const ImDrawVert* vertices, const ImDrawIdx* corners) {
    const ImDrawIdx a = corners[0];
    for (int i = 0; i < 6; ++i) {
        constexpr int kOrder[] = {0, 1, 2, 0, 2, 3};
        if (corners[i] != a + kOrder[i]) return false;
    }
    const ImVec2 from = vertices[a].uv, to = vertices[a + 2].uv;
    return from.x < to.x && from.y < to.y && vertices[a + 1].uv.y == from.y && vertices[a + 3].uv.x == from.x;
}

// Whether the letter is a part of one of the fonts' letters: labels of buttons and the like are cut so. Later releases of ImGui keep
// their fonts elsewhere.
bool is_part([[maybe_unused]] const ImVec2& from_uv, [[maybe_unused]] const ImVec2& to_uv) {
#if IMGUI_VERSION_NUM < 19200
    for (const ImFont* const font : ImGui::GetIO().Fonts->Fonts)
        for (const ImFontGlyph& glyph : font->Glyphs)
            if (glyph.V0 <= from_uv.y && to_uv.y <= glyph.V1 && glyph.U0 <= from_uv.x && to_uv.x <= glyph.U1)
                return glyph.U0 < from_uv.x || to_uv.x < glyph.U1;
#endif
    return false;
}

}  // namespace

std::vector<std::array<int, 2>> cut_letters(const ImDrawData& data) {
    constexpr float kHidden = 1.5F;  // pixels of a letter's rectangle that may have no ink
    std::vector<std::array<int, 2>> cut;
    for (int n = 0; n < data.CmdListsCount; ++n) {
        const ImDrawList& list = *data.CmdLists[n];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback) continue;
            const ImDrawVert* const vertices = list.VtxBuffer.Data + command.VtxOffset;
            const ImDrawIdx* const indices = list.IdxBuffer.Data + command.IdxOffset;
            for (unsigned i = 0; i + 6 <= command.ElemCount;) {
                if (!is_letter(vertices, indices + i)) {
                    i += 3;
                    continue;
                }
                const ImVec2 from = vertices[indices[i]].pos, to = vertices[indices[i + 2]].pos;
                const ImVec4& clip = command.ClipRect;
                const bool is_in_sight = from.x < clip.z && to.x > clip.x && from.y < clip.w && to.y > clip.y;
                const bool is_cut = from.x < clip.x - kHidden || to.x > clip.z + kHidden ||
                                    is_part(vertices[indices[i]].uv, vertices[indices[i + 2]].uv);
                if (is_in_sight && is_cut)
                    cut.push_back({static_cast<int>((from.x + to.x) / 2), static_cast<int>((from.y + to.y) / 2)});
                i += 6;
            }
        }
    }
    return cut;
}

}  // namespace twinlight::demo
