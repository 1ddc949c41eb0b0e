// Who may include whom (docs/architecture.md, "Layers"). A file's layer is its folder under src.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

namespace twinlight {

namespace {

using Layers = std::set<std::string>;

const std::map<std::string, Layers>& allowed() {
    static const std::map<std::string, Layers> table = {
        {"math", {}},
        {"command", {"math"}},
        {"image", {"math"}},
        {"spectrum", {"math", "command"}},
        {"shape", {"math", "command", "spectrum"}},
        {"state", {"math", "command", "spectrum", "shape"}},
        {"lighting", {"math"}},
        {"effect", {"math", "command", "spectrum", "shape", "state", "lighting"}},
        {"context", {"math", "image"}},
        {"trace", {"math", "command"}},
        {"scenes", {"math", "command", "image", "trace"}},  // reads scene files and recordings
        {"reference", {"math", "command", "spectrum", "state", "shape", "lighting", "image"}},
        {"stages", {"math", "command", "shape", "state", "effect", "context"}},
        {"fixed", {"math", "command", "spectrum", "shape", "state", "effect", "stages", "context", "image"}},
        {"programmable", {"math", "command", "spectrum", "state", "effect", "stages", "shape", "context", "image"}},
        {"report", {"math", "command", "state", "effect", "image"}},  // the renderers come as functions
        {"study",
         {"math", "command", "spectrum", "shape", "state", "image", "report"}},  // the renderers come as functions
        {"fuzz",
         {"math", "command", "state", "shape", "lighting", "image", "context", "fixed", "programmable", "reference",
          "report"}},
        {"check", {"math", "command", "state", "image", "context", "fixed", "programmable", "reference", "fuzz"}},
        {"app", {}},  // all
    };
    return table;
}

TEST(Layers, IncludeOnlyWhatTheyMay) {
    int includes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator("src")) {
        const std::string extension = entry.path().extension();
        if (extension != ".h" && extension != ".cpp") continue;
        const std::string path = entry.path().generic_string();
        const std::string layer = path.substr(4, path.find('/', 4) - 4);
        ASSERT_TRUE(allowed().contains(layer)) << path << ": add its layer to the table";
        std::ifstream file(path);
        for (std::string line; std::getline(file, line);) {
            if (!line.starts_with("#include ")) continue;
            const bool is_own = line[9] == '"';
            const std::string name = line.substr(10, line.find_first_of("\">", 10) - 10);
            const bool names_gl = name.starts_with("GL/");
            if (names_gl) {
                EXPECT_TRUE(layer == "context" || path.starts_with("src/app/demo/"))
                    << path << " includes " << name << "; GL's headers come through context/gl.h";
                EXPECT_TRUE(!name.starts_with("GL/freeglut") && !name.starts_with("GL/glut")
                                ? true
                                : path.starts_with("src/app/demo/"))
                    << path << " includes GLUT, which belongs to the demo alone";
            }
            if (!is_own) continue;
            ++includes;
            const std::size_t slash = name.find('/');
            const std::string included = name.substr(0, slash);
            ASSERT_NE(slash, std::string::npos) << path << ": #include \"" << name << "\" lacks its folder";
            if (layer == "app" || included == layer) continue;
            EXPECT_TRUE(allowed().at(layer).contains(included))
                << path << " includes " << name << ", but " << layer << " may not include " << included;
        }
    }
    EXPECT_GT(includes, 100);  // the test does read files
}

// The reference must not share the driver's numbers or the planner's mistakes.
TEST(Layers, KeepTheReferenceFromGlAndFromThePlanner) {
    EXPECT_FALSE(allowed().at("reference").contains("effect"));
    EXPECT_FALSE(allowed().at("reference").contains("context"));
}

}  // namespace

}  // namespace twinlight
