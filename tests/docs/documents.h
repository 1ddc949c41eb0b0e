// The pages that people read, for the tests that hold them against the programs: README, CONTRIBUTING and docs/, in every language.
#pragma once

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/image/file.h"

namespace twinlight {

struct Document {
    std::string path;  // "docs/lint.md"
    std::vector<std::string> lines;
};

inline std::vector<Document> documents() {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator("."))
        if (entry.path().extension() == ".md") paths.push_back(entry.path().filename());
    for (const auto& entry : std::filesystem::recursive_directory_iterator("docs")) {
        // The reports in docs/upstream are written by a command; UpstreamReports has their tests.
        const bool is_report = entry.path().parent_path() == "docs/upstream" && entry.path().filename() != "README.md";
        if (entry.path().extension() == ".md" && !is_report) paths.push_back(entry.path());
    }
    std::ranges::sort(paths);
    std::vector<Document> all;
    for (const std::string& path : paths) {
        Document document{path, {}};
        std::istringstream in(read_file(path));
        for (std::string line; std::getline(in, line);) document.lines.push_back(line);
        all.push_back(std::move(document));
    }
    return all;
}

// A run of lines that are shown as they are: between fences, or four spaces to the right. Its lines lack these spaces.
struct CodeBlock {
    std::size_t first_line = 1;  // in the page, from 1
    std::vector<std::string> lines;
};

inline std::vector<CodeBlock> code_blocks(const Document& document) {
    std::vector<CodeBlock> blocks;
    bool in_fence = false, continues = false, after_blank = true;
    for (std::size_t i = 0; i < document.lines.size(); ++i) {
        const std::string& line = document.lines[i];
        const bool is_fence = line.starts_with("```"), is_blank = line.find_first_not_of(' ') == std::string::npos;
        const bool is_indented = !in_fence && line.starts_with("    ") && !is_blank && (after_blank || continues);
        if (is_fence) {
            in_fence = !in_fence;
            continues = false;
        } else if (in_fence || is_indented) {
            if (!continues) blocks.push_back({i + 1, {}});
            blocks.back().lines.push_back(is_indented ? line.substr(4) : line);
            continues = true;
        } else {
            continues = false;
        }
        after_blank = is_blank;
    }
    return blocks;
}

// A line for the shell, without its prompt and its comment.
struct CommandLine {
    std::size_t line = 1;  // in the page, from 1
    std::string text;
};

// Those lines of a block that begin with a program (and settings such as CC=clang before it); a \ at the end joins two lines.
inline std::vector<CommandLine> command_lines(const CodeBlock& block) {
    static const std::regex command(
        R"((\$ )?(([A-Z_]+=\S*) +)*((sudo )?(build|tools|tests|\.)/[\w./-]+|twinlight(-demo)?|(sudo )?(make|apt-get)|apitrace|cc|c\+\+|g\+\+|git|cd|man|valgrind)( .*)?)");
    std::vector<CommandLine> found;
    for (std::size_t i = 0; i < block.lines.size(); ++i) {
        std::string text = block.lines[i];
        const std::size_t at = block.first_line + i;
        if (!std::regex_match(text, command)) continue;
        while (text.ends_with('\\') && i + 1 < block.lines.size()) {
            text.pop_back();
            text += block.lines[++i];
        }
        if (text.starts_with("$ ")) text = text.substr(2);
        if (const std::size_t comment = text.find(" # "); comment != std::string::npos) text.resize(comment);
        text.resize(text.find_last_not_of(' ') + 1);
        found.push_back({at, text});
    }
    return found;
}

}  // namespace twinlight
