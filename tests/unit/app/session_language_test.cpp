// The window in Chinese: every text has its translation, and every translation is of a text.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "../in_chinese.h"
#include "app/session/keys.h"
#include "app/session/language.h"
#include "app/session/presets.h"
#include "app/session/saving.h"
#include "app/session/session.h"
#include "app/session/tutor.h"
#include "base/image/file.h"
#include "base/text/translation.h"
#include "judge/lint/lint.h"
#include "judge/study/choice.h"
#include "scene/scenes/caption.h"
#include "scene/scenes/load.h"
#include "scene/scenes/scene_groups.h"

namespace twinlight::session::session_language_test {
namespace {

// ---- The sources ----

// A piece of C++: a string, a word, or a sign.
struct Token {
    enum class Kind { kText, kWord, kSign };
    Kind kind = Kind::kSign;
    std::string text;
};

// Without comments. Strings that follow each other are one.
std::vector<Token> tokens_of(std::string_view source) {
    std::vector<Token> tokens;
    const auto is_in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (std::size_t at = 0; at < source.size();) {
        const char c = source[at];
        if (source.substr(at).starts_with("//") || c == '#') {
            at = std::min(source.find('\n', at), source.size());
        } else if (c == '"' || c == '\'') {
            std::string text;
            for (++at; at < source.size() && source[at] != c; ++at) {
                if (source[at] == '\\') ++at;
                text += source[at] == 'n' && source[at - 1] == '\\' ? '\n' : source[at];
            }
            ++at;
            if (c == '\'') continue;
            if (!tokens.empty() && tokens.back().kind == Token::Kind::kText)
                tokens.back().text += text;
            else
                tokens.push_back({Token::Kind::kText, text});
        } else if (is_in_word(c)) {
            const std::size_t start = at;
            // The ' of 1'000 belongs to the number.
            while (at < source.size() && (is_in_word(source[at]) || source[at] == '\'')) ++at;
            tokens.push_back({Token::Kind::kWord, std::string(source.substr(start, at - start))});
        } else {
            if (std::isspace(static_cast<unsigned char>(c)) == 0) tokens.push_back({Token::Kind::kSign, {c}});
            ++at;
        }
    }
    return tokens;
}

constexpr int kAll = -1;

// What a call is given, from the token after its "(": the strings of one argument, counted from 0, or of all.
std::vector<std::string> texts_given(const std::vector<Token>& tokens, std::size_t at, int argument) {
    std::vector<std::string> texts;
    for (int depth = 0, now = 0; at < tokens.size() && depth >= 0; ++at) {
        const auto& [kind, text] = tokens[at];
        if (kind == Token::Kind::kText && (now == argument || argument == kAll)) texts.push_back(text);
        if (kind != Token::Kind::kSign) continue;
        if (text == "(" || text == "{" || text == "[") ++depth;
        if (text == ")" || text == "}" || text == "]") --depth;
        if (text == "," && depth == 0) ++now;
    }
    return texts;
}

// A function that translates a text it is given, and the folder where it does.
struct Translator {
    std::string_view name, folder;
    int argument = 0;
};
constexpr Translator kTranslators[] = {
    {"tr", "src"},
    {"checkbox", "src/app/demo", kAll},
    {"header", "src/app/demo", kAll},
    {"button", "src/app/demo", kAll},
    {"of_model", "src/app/demo", kAll},
    {"described", "src/app/demo", kAll},
    // Those that make errors get a format.
    {"fail", "src/scene/command", 1},
    {"fail", "src/scene/trace", 1},
    {"refuse", "src/scene/trace", 2},
    {"expect", "src/scene/command", 1},
    {"raise", "src/scene/state", 2},
    {"refused", "src/scene/state", 2},
    {"undefined", "src/scene/state", 2},
    {"counts", "src/scene/state", 1},
    {"refuse", "src/scene/shape", 0},
    {"refuse_unless", "src/scene/shape", 2},
    {"refuse", "src/scene/mesh", 1},
};

bool is_source(const std::filesystem::path& path) {
    return path.filename() != "chinese.def" &&
           (path.extension() == ".cpp" || path.extension() == ".h" || path.extension() == ".def");
}

template <class Visit>
void for_each_source(const char* folder, const Visit& visit) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (is_source(entry.path())) visit(entry.path().generic_string(), tokens_of(read_file(entry.path().string())));
}

// ---- The texts ----

std::set<std::string> rows() {
    std::set<std::string> all;
    for (const Translation& row : chinese()) all.insert(row.english);
    return all;
}

// What the window shows of the built-in scenes and the tutors.
std::set<std::string> texts_of_scenes() {
    std::set<std::string> texts;
    const auto add = [&](const std::shared_ptr<const CommandList>& list) {
        const Caption caption = caption_of(*list);
        texts.insert({caption.title, caption.notice});
        texts.insert(list->steps.begin(), list->steps.end());
        for (const SceneLabel& label : make_scene(list, {}).frame.labels) texts.insert(label.text);
    };
    for (const EmbeddedFile& file : kSceneFiles) {
        const auto scene = load_commands(built_in_name(file));
        add(scene);
        for (std::size_t step = 2; step <= scene->steps.size(); ++step)
            add(load_commands(built_in_name(file), std::to_string(step)));
    }
    for (const TutorName& tutor : kTutors) add(tutor_scene(tutor.key));
    return texts;
}

// Whether a text has words: numbers, names and formulas are the same in each language.
bool has_words(std::string_view text) {
    int letters = 0;
    for (const char c : text) {
        letters = c >= 'a' && c <= 'z' ? letters + 1 : 0;
        if (letters == 4) return true;
    }
    return false;
}

// The texts in tables that tr() gets.
std::set<std::string> texts_of_tables() {
    std::set<std::string> texts = {
#define HELP(effect, parameter, pname, words, section) words,
#include "app/session/argument_help.def"
#undef HELP
    };
    for (const Key& key : keys())
        if (!key.what.empty()) texts.insert(std::string(key.what));
    for (const PanelName& panel : kPanels) texts.insert(panel.title);
    for (const FormName& form : kForms) texts.insert({form.words, form.what});
    texts.insert(kRendererTitles.begin(), kRendererTitles.end());
    for (const MaterialPreset& preset : material_presets()) texts.insert(std::string(preset.name));
    for (const SceneGroup& group : scene_groups()) texts.insert(std::string(group.heading));
    for (const lint::Rule& rule : lint::rules()) texts.insert(std::string(rule.why));
    return texts;
}

TEST(Chinese, HasEachTextOfTheSources) {
    const std::set<std::string> known = rows();
    std::map<std::string_view, std::size_t> found;
    for_each_source("src", [&](const std::string& file, const std::vector<Token>& tokens) {
        for (std::size_t i = 0; i + 1 < tokens.size(); ++i)
            for (const auto& [name, folder, argument] : kTranslators) {
                if (tokens[i].kind != Token::Kind::kWord || tokens[i].text != name || tokens[i + 1].text != "(" ||
                    !file.starts_with(folder))
                    continue;
                for (const std::string& text : texts_given(tokens, i + 2, argument)) {
                    EXPECT_TRUE(known.contains(text) || (name != "tr" && !has_words(text))) << file << ": " << text;
                    ++found[name];
                }
            }
    });
    for (const Translator& one : kTranslators) EXPECT_GT(found[one.name], 0U) << one.name;
    EXPECT_GT(found["tr"], 300U);
    EXPECT_GT(found["fail"], 200U);
    EXPECT_GT(found["raise"], 100U);
}

TEST(Chinese, HasEachTextOfTheTables) {
    const std::set<std::string> known = rows();
    for (const std::string& text : texts_of_tables()) EXPECT_TRUE(known.contains(text)) << text;
}

TEST(Chinese, HasEachTextOfTheBuiltInScenes) {
    const std::set<std::string> known = rows();
    for (const std::string& text : texts_of_scenes()) EXPECT_TRUE(known.contains(text) || !has_words(text)) << text;
}

TEST(Chinese, HasNoTextThatNothingShows) {
    std::set<std::string> shown = texts_of_scenes();
    for_each_source("src", [&](const std::string&, const std::vector<Token>& tokens) {
        for (const Token& token : tokens)
            if (token.kind == Token::Kind::kText) shown.insert(token.text);
    });
    for (const int error :
         {ENOENT, EACCES, EISDIR, ENOTDIR, EEXIST, ENAMETOOLONG, ELOOP, EMFILE, EROFS, ENOSPC, EDQUOT, EIO})
        shown.insert(std::strerror(error));
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS, SIGKILL}) shown.insert(::strsignal(signal));
    for (const std::string& row : rows()) EXPECT_TRUE(shown.contains(row)) << row;
    EXPECT_EQ(rows().size(), chinese().size()) << "a text has two rows";
}

// The fields of a format, "{}" as "{0}" and so on, and what printf() takes.
std::multiset<std::string> fields_of(std::string_view text) {
    std::multiset<std::string> fields;
    int next = 0;
    bool is_counted = false, is_numbered = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text.substr(at).starts_with("{{")) {
            ++at;
        } else if (text[at] == '{') {
            const std::size_t end = text.find('}', at), colon = std::min(text.find(':', at), end);
            std::string number(text.substr(at + 1, colon - at - 1));
            (number.empty() ? is_counted : is_numbered) = true;
            if (number.empty()) number = std::to_string(next++);
            fields.insert(number + std::string(text.substr(colon, end - colon)));
            at = end;
        } else if (text[at] == '%') {
            const std::size_t end = text.find_first_not_of(".0123456789", at + 1);
            if (end != text.npos && std::string_view("dfgs").find(text[end]) != std::string_view::npos)
                fields.insert(std::string(text.substr(at, end + 1 - at)));
        }
    }
    if (is_counted && is_numbered) fields.insert("{} beside {0}, which fmt does not take");
    return fields;
}

TEST(Chinese, HasTheFieldsOfTheEnglishText) {
    EXPECT_EQ(fields_of("{} of {:.2f} in %.3g"), fields_of("{1:.2f}{0}%.3g"));
    EXPECT_NE(fields_of("{} of {}"), fields_of("{}"));
    EXPECT_NE(fields_of("{} of {}"), fields_of("{} of {1}"));
    for (const auto& [english, translated] : chinese()) EXPECT_EQ(fields_of(english), fields_of(translated)) << english;
}

TEST(Chinese, IsShownByTheWindowOnly) {
    EXPECT_STREQ(tr("Undo"), "Undo");
    const InChinese chinese_now;
    EXPECT_STREQ(tr("Undo"), "撤销");
    EXPECT_EQ(tr("{} of {} follows glColor; glMaterial cannot change it", "GL_SPECULAR", tr("both faces")),
              "两面的 GL_SPECULAR 跟随 glColor；glMaterial 改变不了它");
    EXPECT_EQ(tr("no such text"), std::string("no such text"));
}

TEST(Chinese, NamesWhatTheTabAccuracyMeasures) {
    const InChinese chinese_now;
    const auto words = [](Shading shading) { return study::Choice{.shading = shading, .slices = 16}.words(); };
    EXPECT_EQ(words(Shading::kGouraud), "使用 uniform 的着色器，Gouraud 着色，16 个 slices");
    EXPECT_EQ(words(Shading::kPhong), "使用 uniform 的着色器，Phong 着色，16 个 slices");
    EXPECT_EQ(words(Shading::kExact), "使用 uniform 的着色器，精确曲面，16 个 slices");
}

TEST(Chinese, CaptionsAreTranslatedOnlyForBuiltInScenes) {
    const Caption own{.title = "My scene: a ball.", .notice = "Notice it. And that.", .all = "All of it."};
    const Caption tutor = caption_of(tutor_text("light"));
    const InChinese chinese_now;
    EXPECT_EQ(translated(own).all, own.all);
    const Caption shown = translated(tutor);
    EXPECT_EQ(before_colon(shown.title), "光源");
    EXPECT_EQ(shown.all, shown.title + "\n\n" + shown.notice);
    EXPECT_EQ(before_colon(own.title), "My scene");
    EXPECT_EQ(first_sentence(own.notice), "Notice it.");
    EXPECT_EQ(first_sentence("注意它。还有那个。"), "注意它。");
}

}  // namespace
}  // namespace twinlight::session::session_language_test
