#include "recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <sstream>

namespace twinlight {
namespace {

// n numbers, or as many "-".
template <class Vector>
std::optional<Vector> read_vector(std::istringstream& words) {
    Vector v{0};
    bool sent = true;
    for (int i = 0; i < v.length(); ++i) {
        std::string word;
        words >> word;
        sent = word != "-";
        if (sent) v[i] = std::strtod(word.c_str(), nullptr);
    }
    EXPECT_TRUE(words) << words.str();
    return sent ? std::optional(v) : std::nullopt;
}

template <class Vector>
double distance(const std::optional<Vector>& a, const std::optional<Vector>& b) {
    return a && b ? glm::distance(*a, *b) : 0;
}

bool is_nan(const glm::dvec3& v) { return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z); }

}  // namespace

std::vector<RecordedCall> record(const std::vector<std::string>& calls, const std::string& display) {
    const char* build = std::getenv("TWINLIGHT_BUILD");
    // freeglut frees nothing at exit: a leak checker would call that a failure.
    std::string command =
        "ASAN_OPTIONS=detect_leaks=0 DISPLAY=" + display + " '" + (build ? build : "build") + "/shape-recorder'";
    for (const std::string& call : calls) command += " '" + call + "'";
    std::FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
    std::string text;
    if (pipe) {
        std::vector<char> buffer(1 << 16);
        while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
        EXPECT_EQ(::pclose(pipe), 0) << command;
    }

    std::vector<RecordedCall> recordings;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string word, how;
        if (line.starts_with("call ")) {
            recordings.push_back({line.substr(5), {}, {}});
        } else if (line.starts_with("error ")) {
            words >> word >> recordings.back().error.emplace();
        } else if (line.starts_with("draw ")) {
            SentPart part;
            words >> word >> how >> part.mode;
            part.immediate = how == "immediate";
            recordings.back().parts.push_back(part);
        } else {
            const auto position = read_vector<glm::dvec3>(words);
            const auto normal = read_vector<glm::dvec3>(words);
            recordings.back().parts.back().vertices.push_back(
                {position.value(), normal, read_vector<glm::dvec2>(words)});
        }
    }
    return recordings;
}

std::vector<SentPart> sent_parts(const std::vector<ShapePart>& parts) {
    std::vector<SentPart> result;
    for (const ShapePart& part : parts) {
        SentPart sent{part.mode, part.immediate, {}};
        const std::size_t count = part.indices.empty() ? part.vertices.size() : part.indices.size();
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t index = part.indices.empty() ? i : part.indices[i];
            const ShapeVertex& v = part.vertices[index];
            sent.vertices.push_back({v.position_object,
                                     index >= part.first_normal ? std::optional(v.normal_object) : std::nullopt,
                                     part.sends_tex_coords ? std::optional(v.tex_coord) : std::nullopt});
        }
        result.push_back(std::move(sent));
    }
    return result;
}

double expect_same(const std::vector<SentPart>& ours, const std::vector<SentPart>& theirs,
                   const std::function<Tolerance(std::size_t, std::size_t)>& tolerance) {
    double worst = 0;
    int failures = 0;
    EXPECT_EQ(ours.size(), theirs.size()) << "parts";
    for (std::size_t p = 0; p < std::min(ours.size(), theirs.size()); ++p) {
        EXPECT_EQ(ours[p].mode, theirs[p].mode) << "part " << p;
        EXPECT_EQ(ours[p].immediate, theirs[p].immediate) << "part " << p;
        EXPECT_EQ(ours[p].vertices.size(), theirs[p].vertices.size()) << "part " << p;
        if (ours[p].vertices.size() != theirs[p].vertices.size()) continue;
        for (std::size_t i = 0; i < ours[p].vertices.size() && failures < 10; ++i) {
            const SentVertex &a = ours[p].vertices[i], &b = theirs[p].vertices[i];
            const Tolerance allowed = tolerance(p, i);
            const auto within = [&](double found, double limit, const char* what) {
                EXPECT_LE(found, limit) << what << " of vertex " << i << " of part " << p;
                failures += found <= limit ? 0 : 1;
                if (limit > 0) worst = std::max(worst, found / limit);
            };
            EXPECT_EQ(a.normal_object.has_value(), b.normal_object.has_value()) << "vertex " << i << " of part " << p;
            EXPECT_EQ(a.tex_coord.has_value(), b.tex_coord.has_value()) << "vertex " << i << " of part " << p;
            within(glm::distance(a.position_object, b.position_object), allowed.position, "position");
            if (b.normal_object && is_nan(*b.normal_object)) {
                EXPECT_EQ(a.normal_object, glm::dvec3(0)) << "vertex " << i << " of part " << p;
            } else {
                within(distance(a.normal_object, b.normal_object), allowed.normal, "normal");
            }
            within(distance(a.tex_coord, b.tex_coord), allowed.tex_coord, "texture coordinate");
        }
    }
    return worst;
}

}  // namespace twinlight
