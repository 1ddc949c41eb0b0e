// The rows of a table of bad input, tests/bad_input/NAME.txt: a part of the error, a tab, and the input.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "base/image/file.h"

namespace twinlight {

struct Row {
    std::string message, input;
};

// \n, \t, \\ and \x1b in a row stand for these bytes.
inline std::string unescaped(const std::string& text) {
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\' || i + 1 == text.size()) {
            bytes += text[i];
            continue;
        }
        const char c = text[++i];
        if (c == 'x') {
            bytes += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
            i += 2;
        } else {
            bytes += c == 'n' ? '\n' : c == 't' ? '\t' : c;
        }
    }
    return bytes;
}

inline std::vector<Row> rows_of(const std::string& name) {
    std::vector<Row> rows;
    std::istringstream lines(read_file("tests/bad_input/" + name + ".txt"));
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::size_t tab = line.find('\t');
        EXPECT_NE(tab, std::string::npos) << line;
        rows.push_back({unescaped(line.substr(0, tab)), unescaped(line.substr(tab + 1))});
    }
    return rows;
}

}  // namespace twinlight
