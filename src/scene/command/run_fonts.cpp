// GLUT's texts in a whole program, as the commands that freeglut 3.4 sends for them (src/fg_font.c).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/math/as_float.h"
#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

constexpr int kFirstCharacter = 32, kLastCharacter = 126;  // others are drawn as a space

struct BitmapFont {
    std::string_view name;
    int height = 0;
    double yorig = 0;
    std::string_view glyphs;
};
#define BITMAP_FONT(name, height, yorig, glyphs) {#name, height, yorig, glyphs},
constexpr BitmapFont kBitmapFonts[] = {
#include "scene/command/bitmap_fonts.def"
};
#undef BITMAP_FONT

struct Strokes {
    int character = 0;
    double width = 0, left = 0, mono_left = 0;
    std::string_view lines, mono_lines;
};
#define STROKES(character, width, left, mono_left, lines, mono_lines) \
    {character, width, left, mono_left, lines, mono_lines},
constexpr Strokes kStrokes[] = {
#include "scene/command/stroke_fonts.def"
};
#undef STROKES
static_assert(std::size(kStrokes) == kLastCharacter - kFirstCharacter + 1);
constexpr double kMonoWidth = 104.762, kStrokeHeight = 152.381;

constexpr std::string_view kStrokeFonts[] = {"GLUT_STROKE_ROMAN", "GLUT_STROKE_MONO_ROMAN"};
// freeglut's numbers: the stroke fonts have 0 and 1, the bitmap fonts 2 to 8.
constexpr std::int64_t kFirstBitmapFont = 2;

std::size_t index_of(int character) {
    return static_cast<std::size_t>(
        character < kFirstCharacter || character > kLastCharacter ? 0 : character - kFirstCharacter);
}

struct Glyph {
    int width = 0;
    std::vector<std::byte> rows{};
};

Glyph glyph_of(const BitmapFont& font, int character) {
    std::size_t at = 0;
    const auto byte = [&] {
        unsigned value = 0;
        std::from_chars(font.glyphs.data() + at, font.glyphs.data() + at + 2, value, 16);
        at += 2;
        return value;
    };
    for (std::size_t i = index_of(character);; --i) {
        const unsigned width = byte(), below = byte(), rows = byte();
        const std::size_t row = (width + 7) / 8;
        if (i > 0) {
            at += 2 * rows * row;
            continue;
        }
        Glyph glyph{static_cast<int>(width), std::vector<std::byte>(row * static_cast<std::size_t>(font.height))};
        for (std::size_t k = 0; k < rows * row; ++k) glyph.rows[below * row + k] = static_cast<std::byte>(byte());
        return glyph;
    }
}

double stroke_width(bool is_mono, int character) { return is_mono ? kMonoWidth : kStrokes[index_of(character)].width; }

}  // namespace

// The pointer that is a font: freeglut's number of it.
std::optional<Value> font_named(std::string_view name) {
    const auto pointer = [](std::ptrdiff_t number) { return Value{.type = Value::Type::kPointer, .offset = number}; };
    const auto stroke = std::ranges::find(kStrokeFonts, name);
    if (stroke != std::end(kStrokeFonts)) return pointer(stroke - std::begin(kStrokeFonts));
    const auto bitmap = std::ranges::find(kBitmapFonts, name, &BitmapFont::name);
    if (bitmap != std::end(kBitmapFonts)) return pointer(bitmap - std::begin(kBitmapFonts) + kFirstBitmapFont);
    return std::nullopt;
}

void Reader::send(CommandId id, std::vector<double> values, const Place& place, std::shared_ptr<const Memory> memory) {
    check_room_for_command(place);
    commands_.push_back({id, std::move(values), place, std::move(memory)});
}

// A text in a bitmap font: freeglut sets how glBitmap reads its rows and sets it back afterwards.
void Reader::send_bitmaps(std::size_t number, std::string_view text, const Place& place) {
    const BitmapFont& font = kBitmapFonts[number];
    send(CommandId::glPushClientAttrib, {kGL_CLIENT_PIXEL_STORE_BIT}, place);
    for (const Enum name : {kGL_UNPACK_SWAP_BYTES, kGL_UNPACK_LSB_FIRST, kGL_UNPACK_ROW_LENGTH, kGL_UNPACK_SKIP_ROWS,
                            kGL_UNPACK_SKIP_PIXELS, kGL_UNPACK_ALIGNMENT})
        send(CommandId::glPixelStorei, {static_cast<double>(name), name == kGL_UNPACK_ALIGNMENT ? 1.0 : 0.0}, place);
    double x = 0;
    for (const char c : text) {
        if (c == '\n' && text.size() > 1) {
            send(CommandId::glBitmap, {0, 0, 0, 0, -x, -static_cast<double>(font.height), 0}, place);
            x = 0;
            continue;
        }
        std::shared_ptr<const Memory>& memory = program_->glyphs[{number, c}];
        Glyph glyph = glyph_of(font, static_cast<unsigned char>(c));
        if (!memory) memory = std::make_shared<Memory>(Memory{Kind::kUbyte, std::move(glyph.rows)});
        const auto width = static_cast<double>(glyph.width);
        send(CommandId::glBitmap, {width, static_cast<double>(font.height), 0, font.yorig, width, 0, 0}, place, memory);
        x += width;
    }
    send(CommandId::glPopClientAttrib, {}, place);
}

void Reader::send_strokes(bool is_mono, std::string_view text, const Place& place) {
    // freeglut has six digits, at most four of them after the point.
    const auto place_of = [](double left, char step, char first) {
        const double value = left + (step - first) * 100.0 / 21, digits = value >= 100 ? 1e3 : 1e4;
        return as_float(std::round(value * digits) / digits);
    };
    double x = 0;
    for (const char c : text) {
        if (c == '\n' && text.size() > 1) {
            send(CommandId::glTranslatef, {as_float(-x), as_float(-kStrokeHeight), 0}, place);
            x = 0;
            continue;
        }
        const Strokes& strokes = kStrokes[index_of(static_cast<unsigned char>(c))];
        const double left = is_mono ? strokes.mono_left : strokes.left;
        std::string_view lines = is_mono && !strokes.mono_lines.empty() ? strokes.mono_lines : strokes.lines;
        while (!lines.empty()) {
            const std::string_view line = lines.substr(0, lines.find(' '));
            lines.remove_prefix(std::min(lines.size(), line.size() + 1));
            send(CommandId::glBegin, {kGL_LINE_STRIP}, place);
            for (std::size_t i = 0; i + 1 < line.size(); i += 2)
                send(CommandId::glVertex2f, {place_of(left, line[i], '0'), place_of(0, line[i + 1], '7')}, place);
            send(CommandId::glEnd, {}, place);
        }
        const double width = stroke_width(is_mono, static_cast<unsigned char>(c));
        send(CommandId::glTranslatef, {as_float(width), 0, 0}, place);
        x += width;
    }
}

// glutBitmapCharacter, glutStrokeString, glutBitmapLength and others: nullopt for another name.
std::optional<Value> Reader::call_of_fonts(const Token& name) {
    constexpr std::string_view kAll[] = {"glutBitmapCharacter", "glutBitmapString", "glutBitmapWidth",
                                         "glutBitmapLength",    "glutBitmapHeight", "glutStrokeCharacter",
                                         "glutStrokeString",    "glutStrokeWidth",  "glutStrokeLength",
                                         "glutStrokeHeight",    "glutStrokeWidthf", "glutStrokeLengthf"};
    if (std::ranges::find(kAll, name.text) == std::end(kAll)) return std::nullopt;
    const bool is_bitmap = name.text.starts_with("glutBitmap");
    const auto is_form = [&](std::string_view form) {
        return name.text.substr(std::string_view("glutBitmap").size()).starts_with(form);
    };
    const std::vector<Value> given = values_in_parentheses();
    const std::size_t wanted = is_form("Height") ? 1 : 2;
    if (given.size() != wanted) fail(name.place, "{} takes {}", name.text, arguments_text(wanted));
    const std::int64_t font = given[0].is_pointer() ? given[0].offset : given[0].is_integer() ? given[0].integer : -1;
    const std::int64_t first = is_bitmap ? kFirstBitmapFont : 0;
    const auto count = static_cast<std::int64_t>(is_bitmap ? std::size(kBitmapFonts) : std::size(kStrokeFonts));
    if (given[0].object || font < first || font >= first + count)
        fail(name.place, "{} needs a font such as {}", name.text,
             is_bitmap ? "GLUT_BITMAP_HELVETICA_18" : "GLUT_STROKE_ROMAN");
    const auto number = static_cast<std::size_t>(font - first);
    const bool is_mono = number == 1;
    if (is_form("Height")) return is_bitmap ? integer(kBitmapFonts[number].height) : real(kStrokeHeight, true);
    std::string text;
    if (is_form("String") || is_form("Length"))
        text = text_behind(given[1], name.place);
    else
        text = static_cast<char>(in_kind(given[1], Kind::kByte, name.place).integer);
    if (is_form("Width") || is_form("Length")) {
        double width = 0;
        for (const char c : text) {
            const auto character = static_cast<unsigned char>(c);
            width += is_bitmap ? glyph_of(kBitmapFonts[number], character).width : stroke_width(is_mono, character);
        }
        return name.text.ends_with('f') ? real(width, true) : integer(static_cast<std::int64_t>(width));
    }
    if (is_bitmap)
        send_bitmaps(number, text, name.place);
    else
        send_strokes(is_mono, text, name.place);
    return integer(0);
}

}  // namespace twinlight
