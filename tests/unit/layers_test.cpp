// Who may include whom. A file's wing is its folder under src, its room the rest of its folder's path.
// docs/architecture.md, "Layers", shows the same two tables; a test compares them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace twinlight::layers_test {

namespace {

using Names = std::set<std::string>;
using Table = std::map<std::string, Names>;

// The wings that a wing may include, beside itself.
const Table& wings() {
    static const Table table = {
        {"base", {}},
        {"scene", {"base"}},
        {"lighting", {"base"}},
        {"render", {"base", "scene", "lighting"}},
        {"judge", {"base", "scene", "lighting", "render"}},
        {"app", {"base", "scene", "lighting", "render", "judge"}},
    };
    return table;
}

// The rooms of its own wing that a room may include, beside itself.
const std::map<std::string, Table>& rooms() {
    static const std::map<std::string, Table> table = {
        {"base", {{"math", {}}, {"image", {"math", "text"}}, {"text", {}}, {"threads", {}}}},
        {"scene",
         {{"command", {}},
          {"spectrum", {}},
          {"shape", {"command", "spectrum"}},
          {"frame", {"command", "spectrum", "shape"}},
          {"state", {"command", "spectrum", "shape", "frame"}},
          {"recorded", {"command", "frame", "state"}},
          {"trace", {"command"}},
          {"record", {"command", "trace"}},
          {"mesh", {"command"}},
          {"scenes", {"command", "trace", "mesh"}}}},
        {"render",
         {{"context", {}},
          {"effect", {}},
          {"stages", {"context"}},
          {"fixed", {"effect", "stages", "context"}},
          {"programmable/numbers", {"effect"}},
          {"programmable/text", {"effect", "programmable/numbers"}},
          {"programmable/export", {"effect", "programmable/numbers", "programmable/text"}},
          {"programmable", {"effect", "stages", "context", "programmable/numbers", "programmable/text"}},
          // The reference shares neither the driver's numbers nor the planner's mistakes.
          {"reference/textures", {}},
          {"reference/vertices", {"reference/textures"}},
          {"reference/geometry", {"reference/textures", "reference/vertices"}},
          {"reference", {"reference/textures", "reference/vertices", "reference/geometry"}},
          {"webgl",
           {"effect", "programmable/numbers", "programmable/text", "programmable/export", "reference/vertices",
            "reference/geometry", "reference"}},
          {"webgpu", {"effect", "programmable/text", "programmable/export", "webgl"}}}},
        {"judge",
         {{"compare", {}},
          {"report", {"compare"}},
          {"study", {"report"}},
          {"fuzz", {"compare", "check", "oracle"}},
          {"check", {"compare", "oracle"}},
          {"conformance", {"compare", "check"}},
          {"lint", {}},
          {"lesson", {"lint"}},
          {"explain", {}},
          {"oracle", {}}}},
        {"app",
         {{"cli", {"session"}}, {"session", {}}, {"demo", {"session"}}, {"web", {"session"}}, {"web/compat", {}}}},
    };
    return table;
}

// Rooms, with those inside them, that may include only some of the wings below their own.
const Table& narrower() {
    static const Table table = {
        {"render/context", {"base"}},
        // Only the fixed function sees commands and GL's state machine; the others draw a Frame.
        {"render/fixed", {"base", "scene"}},
        {"render/effect", {"base", "lighting", "scene/frame", "scene/shape"}},
        {"render/stages", {"base", "scene/frame", "scene/shape"}},
        {"render/programmable", {"base", "scene/command", "scene/frame"}},  // names of commands in exported C
        {"render/reference", {"base", "lighting", "scene/frame", "scene/shape", "scene/spectrum"}},
        {"render/webgl", {"base", "scene/frame"}},
        {"render/webgpu", {"base", "scene/command", "scene/frame"}},  // names of enumerants in layout.json
        // The renderers come as functions.
        // It judges everything else that lights, so it shares only the reader of commands.
        {"judge/oracle", {"scene"}},
        {"judge/report", {"base", "scene", "render"}},
        {"judge/study", {"base", "scene", "render"}},
    };
    return table;
}

const Names& wings_below(const std::string& wing, const std::string& room) {
    const std::string outer = wing + "/" + room.substr(0, room.find('/'));
    return narrower().contains(outer) ? narrower().at(outer) : wings().at(wing);
}

struct Path {
    std::string wing, room;  // the room is empty for a file that is in no room
};
Path path_of(const std::string& file) {  // below src
    const std::size_t first = file.find('/');
    if (first == std::string::npos) return {};
    const std::size_t last = file.rfind('/');
    return {file.substr(0, first), last == first ? "" : file.substr(first + 1, last - first - 1)};
}

bool may_include(const Path& from, const Path& to) {
    if (from.wing == to.wing) {
        // What is in no room is everybody's in the wing.
        return from.room == to.room || to.room.empty() || rooms().at(from.wing).at(from.room).contains(to.room);
    }
    const Names& allowed = wings_below(from.wing, from.room);
    return allowed.contains(to.wing) || allowed.contains(to.wing + "/" + to.room);
}

std::vector<std::string> sources(const char* folder = "src") {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension();
        const std::string path = entry.path().generic_string();
        if (path.starts_with("src/judge/conformance/suite/")) continue;  // C for other people's systems
        if (extension == ".h" || extension == ".cpp") paths.push_back(path);
    }
    return paths;
}

TEST(Layers, IncludeOnlyWhatTheyMay) {
    int includes = 0;
    for (const std::string& path : sources()) {
        if (path == "src/base/precompiled.h") continue;  // is included in every room
        const Path from = path_of(path.substr(4));
        ASSERT_TRUE(wings().contains(from.wing)) << path << ": add its wing to the table";
        ASSERT_TRUE(from.room.empty() || rooms().at(from.wing).contains(from.room))
            << path << ": add its room to the table";
        std::ifstream file(path);
        for (std::string line; std::getline(file, line);) {
            if (!line.starts_with("#include \"")) continue;
            const std::string name = line.substr(10, line.find('"', 10) - 10);
            const Path to = path_of(name);
            ++includes;
            ASSERT_TRUE(wings().contains(to.wing)) << path << ": #include \"" << name << "\" lacks its folder";
            EXPECT_TRUE(may_include(from, to)) << path << " may not include " << name;
        }
    }
    EXPECT_GT(includes, 100);  // the test does read files
}

// So a header that lacks an include does not compile, though `make headers` leaves it out; and a room hides
// no missing <gtest/gtest.h>.
TEST(Layers, IncludeTheirOwnHeaderFirst) {
    int headers = 0, tests = 0;
    for (const char* folder : {"src", "tests"})
        for (const std::string& path : sources(folder)) {
            if (!path.ends_with(".cpp")) continue;
            std::ifstream file(path);
            std::vector<std::string> includes;
            bool is_test = false;
            for (std::string line; std::getline(file, line);) {
                if (line.starts_with("#include ")) includes.push_back(line.substr(9));
                is_test = is_test || line.starts_with("TEST");
            }
            const std::filesystem::path header = std::filesystem::path(path).replace_extension(".h");
            if (std::filesystem::exists(header)) {
                ++headers;
                ASSERT_FALSE(includes.empty()) << path;
                const std::string whole = "\"" + header.generic_string() + "\"";
                const std::string below_src = "\"" + header.lexically_relative("src").generic_string() + "\"";
                const std::string name = "\"" + header.filename().generic_string() + "\"";
                EXPECT_TRUE(includes[0] == whole || includes[0] == below_src || includes[0] == name)
                    << path << " includes " << includes[0] << " before its own header";
            }
            if (!is_test) continue;
            ++tests;
            EXPECT_TRUE(std::ranges::count(includes, "<gtest/gtest.h>")) << path << " does not include <gtest/gtest.h>";
        }
    EXPECT_GT(headers, 100);
    EXPECT_GT(tests, 100);
}

// Only the window knows GLUT and ImGui; elsewhere GL's headers come through render/context/gl.h.
TEST(Layers, IncludeGlAndImguiInOnePlace) {
    for (const std::string& path : sources()) {
        if (path.starts_with("src/render/programmable/export/")) continue;  // what an exported scene is drawn with
        const bool is_demo = path.starts_with("src/app/demo/");
        std::ifstream file(path);
        for (std::string line; std::getline(file, line);) {
            const bool is_imgui = line.starts_with("#include <imgui") || line.starts_with("#include <backends/imgui");
            EXPECT_TRUE(is_demo || !is_imgui) << path << ": " << line;
            if (!line.starts_with("#include <GL/")) continue;
            EXPECT_TRUE(is_demo || path.starts_with("src/render/context/")) << path << ": " << line;
            EXPECT_TRUE(is_demo || line.find("glut") == std::string::npos) << path << ": " << line;
        }
    }
}

TEST(Layers, HaveNoArrowBackUp) {
    const std::vector<std::string> floors = {"base", "scene", "lighting", "render", "judge", "app"};
    const auto floor = [&](const std::string& wing) { return std::ranges::find(floors, wing) - floors.begin(); };
    for (const auto& [wing, below] : wings())
        for (const std::string& other : below) EXPECT_LT(floor(other), floor(wing)) << wing << " -> " << other;
    // Within a wing: rooms can be put in an order in which each includes only earlier ones.
    for (const auto& [wing, table] : rooms()) {
        Names done;
        for (bool again = true; again;) {
            again = false;
            for (const auto& [room, below] : table)
                if (!done.contains(room) && std::ranges::includes(done, below)) again = done.insert(room).second;
        }
        EXPECT_EQ(done.size(), table.size()) << "rooms of " << wing << " include each other in a circle";
    }
}

// The rows "| wing/room | what it is | other wings | rooms of its wing |" of docs/architecture.md.
TEST(Layers, AreWhatTheDocsShow) {
    std::ifstream docs("docs/architecture.md");
    const auto names = [](const std::string& cell) {
        Names result;
        std::istringstream words(cell);
        for (std::string word; words >> word;) {
            if (word.ends_with(',')) word.pop_back();
            if (word != "-") result.insert(word);
        }
        return result;
    };
    Names seen;
    for (std::string line; std::getline(docs, line);) {
        if (!line.starts_with("| ")) continue;
        std::vector<std::string> cells;
        std::istringstream parts(line.substr(1));
        for (std::string cell; std::getline(parts, cell, '|');)
            cells.push_back(cell.size() > 2 ? cell.substr(1, cell.size() - 2) : "");
        const std::size_t slash = cells.empty() ? std::string::npos : cells[0].find('/');
        const std::string wing = cells.empty() ? "" : cells[0].substr(0, slash);
        if (cells.size() != 4 || !wings().contains(wing)) continue;
        const std::string room = slash == std::string::npos ? "" : cells[0].substr(slash + 1);
        seen.insert(cells[0]);
        EXPECT_EQ(names(cells[2]), wings_below(wing, room)) << line;
        if (room.empty()) continue;
        ASSERT_TRUE(rooms().at(wing).contains(room)) << line;
        EXPECT_EQ(names(cells[3]), rooms().at(wing).at(room)) << line;
    }
    Names all = {"lighting"};  // has no rooms
    for (const auto& [wing, table] : rooms())
        for (const auto& [room, below] : table) all.insert(wing + "/" + room);
    EXPECT_EQ(seen, all);
}

// The rows "| room | part | files |" of docs/architecture.md: each room with more than 25 files, and each of its files once.
TEST(Layers, AreDividedAsTheDocsShow) {
    constexpr std::size_t kLarge = 25;
    std::map<std::string, Names> listed, files;
    std::map<std::string, std::size_t> counts;
    std::ifstream docs("docs/architecture.md");
    bool is_there = false;
    std::string room;
    for (std::string line; std::getline(docs, line);) {
        if (line.starts_with("| room | part | files |")) {
            is_there = true;
            std::getline(docs, line);  // the line below the heads
            continue;
        }
        if (!line.starts_with("|")) is_there = false;
        if (!is_there) continue;
        if (!line.starts_with("| |")) room = line.substr(2, line.find(' ', 2) - 2);
        const std::size_t end = line.rfind('|'), first = line.rfind('|', end - 1) + 1;
        std::istringstream names(line.substr(first, end - first));
        for (std::string name; names >> name;) {
            if (name.ends_with(',')) name.pop_back();
            EXPECT_TRUE(listed[room].insert(name).second) << name << " is listed twice";
        }
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator("src")) {
        const std::string path = entry.path().parent_path().generic_string();
        if (!entry.is_regular_file() || path == "src" || path == "src/scene/scenes") continue;
        ++counts[path.substr(4)];
        files[path.substr(4)].insert(entry.path().stem());
    }
    for (const auto& [name, count] : counts)
        if (count > kLarge) {
            EXPECT_EQ(listed[name], files[name]) << name << " is divided differently, or not at all";
        }
    for (const auto& [name, parts] : listed) EXPECT_GT(counts[name], kLarge) << name << " is not large";
}

}  // namespace

}  // namespace twinlight::layers_test
