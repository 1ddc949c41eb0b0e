#include "app/demo/drawn_texts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "app/demo/theme.h"

namespace twinlight::demo {
namespace {

struct Letter {
    ImVec2 from, to;        // its corners on the screen
    ImVec2 from_uv, to_uv;  // and in the fonts' texture
};

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

// Visits the letters of one window that are in sight, with the rectangle that clips them.
template <class Visit>
void for_each_letter(const ImDrawList& list, const Visit& visit) {
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.UserCallback) continue;
        const ImDrawVert* const vertices = list.VtxBuffer.Data + command.VtxOffset;
        const ImDrawIdx* const indices = list.IdxBuffer.Data + command.IdxOffset;
        for (unsigned i = 0; i + 6 <= command.ElemCount;) {
            if (!is_letter(vertices, indices + i)) {
                i += 3;
                continue;
            }
            const ImDrawVert &from = vertices[indices[i]], &to = vertices[indices[i + 2]];
            const ImVec4& clip = command.ClipRect;
            if (from.pos.x < clip.z && to.pos.x > clip.x && from.pos.y < clip.w && to.pos.y > clip.y)
                visit(Letter{from.pos, to.pos, from.uv, to.uv}, clip);
            i += 6;
        }
    }
}
// The same for all windows.
template <class Visit>
void for_each_letter(const ImDrawData& data, const Visit& visit) {
    for (int n = 0; n < data.CmdListsCount; ++n) for_each_letter(*data.CmdLists[n], visit);
}

std::array<int, 2> middle_of(const Letter& letter) {
    return {static_cast<int>((letter.from.x + letter.to.x) / 2), static_cast<int>((letter.from.y + letter.to.y) / 2)};
}

// Whether the two have more than a third of the smaller one's width and height in common.
bool overlap(const Letter& a, const Letter& b) {
    const auto is_common = [](float a_from, float a_to, float b_from, float b_to) {
        const float common = std::min(a_to, b_to) - std::max(a_from, b_from);
        return common > std::min(a_to - a_from, b_to - b_from) / 3;
    };
    return is_common(a.from.x, a.to.x, b.from.x, b.to.x) && is_common(a.from.y, a.to.y, b.from.y, b.to.y);
}

// Whether `before` is the outline of a letter: the same one, drawn before and beside it.
bool is_outline(const Letter& before, const Letter& letter) {
    const float reach = at_scale(2);  // show_scene_labels() has 1.5
    return before.from_uv.x == letter.from_uv.x && before.from_uv.y == letter.from_uv.y &&
           std::abs(before.from.x - letter.from.x) < reach && std::abs(before.from.y - letter.from.y) < reach;
}

// The letter of the fonts that this is, or of which it is a part, and its font. Later releases of ImGui keep their fonts elsewhere.
[[maybe_unused]] std::pair<const ImFontGlyph*, const ImFont*> glyph_of([[maybe_unused]] const Letter& letter) {
#if IMGUI_VERSION_NUM < 19200
    for (const ImFont* const font : ImGui::GetIO().Fonts->Fonts)
        for (const ImFontGlyph& glyph : font->Glyphs)
            if (glyph.V0 <= letter.from_uv.y && letter.to_uv.y <= glyph.V1 && glyph.U0 <= letter.from_uv.x &&
                letter.to_uv.x <= glyph.U1)
                return {&glyph, font};
#endif
    return {};
}

// Labels of buttons and the like are cut so.
bool is_part([[maybe_unused]] const Letter& letter) {
#if IMGUI_VERSION_NUM < 19200
    const ImFontGlyph* const glyph = glyph_of(letter).first;
    return glyph && (glyph->U0 < letter.from_uv.x || letter.to_uv.x < glyph->U1);
#else
    return false;
#endif
}

[[maybe_unused]] void append_utf8(std::string& text, unsigned code) {
    const auto add = [&text](unsigned byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (code < 0x80) {
        add(code);
    } else if (code < 0x800) {
        add(0xC0 | code >> 6);
        add(0x80 | (code & 0x3F));
    } else {
        add(0xE0 | code >> 12);
        add(0x80 | (code >> 6 & 0x3F));
        add(0x80 | (code & 0x3F));
    }
}

}  // namespace

std::vector<std::array<int, 2>> cut_letters(const ImDrawData& data) {
    constexpr float kHidden = 1.5F;  // pixels of a letter's rectangle that may have no ink
    std::vector<std::array<int, 2>> cut;
    for_each_letter(data, [&](const Letter& letter, const ImVec4& clip) {
        const ImVec2 &from = letter.from, &to = letter.to;
        if (from.x < clip.x - kHidden || to.x > clip.z + kHidden || is_part(letter)) cut.push_back(middle_of(letter));
    });
    return cut;
}

std::vector<std::array<int, 2>> overlapping_letters(const ImDrawData& data) {
    std::vector<std::array<int, 2>> overlapping;
    for (int n = 0; n < data.CmdListsCount; ++n) {
        std::vector<Letter> letters;
        for_each_letter(*data.CmdLists[n], [&](const Letter& letter, const ImVec4&) {
            std::erase_if(letters, [&](const Letter& before) { return is_outline(before, letter); });
            letters.push_back(letter);
        });
        for (std::size_t i = 0; i < letters.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (overlap(letters[i], letters[j])) overlapping.push_back(middle_of(letters[i]));
    }
    return overlapping;
}

std::vector<std::string> drawn_texts([[maybe_unused]] const ImDrawData& data) {
    std::vector<std::string> texts;
#if IMGUI_VERSION_NUM < 19200
    const ImFont* last_font = nullptr;
    float top = 0, right = 0;
    for_each_letter(data, [&](const Letter& letter, const ImVec4&) {
        const auto [glyph, font] = glyph_of(letter);
        if (!glyph || font == fonts().code || font == fonts().code_bold || font == fonts().code_large) return;
        // A blank is not drawn: it is a gap. A wider gap is the next column.
        const float line = letter.from.y - glyph->Y0, gap = (letter.from.x - right) / font->FontSize;
        constexpr float kBlank = 0.2F, kColumn = 1;
        if (font != last_font || std::abs(line - top) > 2 || gap < -kColumn || gap > kColumn)
            texts.emplace_back();
        else if (gap > kBlank)
            texts.back() += ' ';
        append_utf8(texts.back(), glyph->Codepoint);
        last_font = font;
        top = line;
        right = letter.to.x;
    });
#endif
    return texts;
}

}  // namespace twinlight::demo
