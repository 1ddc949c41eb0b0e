// golden/known_differences is the one list of the driver's departures: every name that a test leaves out stands there,
// and every name there is shown by a test, so that the list is neither short nor stale.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <set>

#include "../property/random_fragments.h"
#include "../property/random_states.h"
#include "command/text.h"
#include "context/context.h"
#include "context/gl.h"
#include "fixed/fixed.h"
#include "fragment_departures.h"
#include "state/state.h"

namespace twinlight {

namespace {

std::set<std::string> listed_names() {
    std::set<std::string> names;
    std::ifstream file("golden/known_differences");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('[') && line.ends_with(']')) names.insert(line.substr(1, line.size() - 2));
    }
    return names;
}

// The same commands carried out by both.
struct Both {
    explicit Both(std::string_view text) : state({.width = 16, .height = 16}) {
        for (const Command& command : read_scene(text, "case.gl", "case").commands) {
            state.apply(command);
            executor.execute(command);
        }
    }
    std::unique_ptr<OffscreenContext> context = make_offscreen_context(16, 16);
    fixed::Executor executor;
    State state;
};

// ---- The departures of the driver's state machine ----

void expect_departure(bool departs) {
    EXPECT_TRUE(departs || !is_listed_driver()) << "the driver keeps to the text now";
}

struct Departure {
    const char* name;
    void (*show)();
};

void single_value_for_a_vector() {
    const Both both("glLightf(GL_LIGHT0, GL_AMBIENT, 1);");
    ASSERT_EQ(both.state.errors().size(), 1u);
    EXPECT_EQ(both.state.errors()[0].code, kGL_INVALID_ENUM);
    expect_departure(glGetError() == GL_NO_ERROR);
}

void alpha_of_glcolor3() {
    const Both both(
        "glBegin(GL_POINTS); glColor4f(1, 1, 1, 0.25); glVertex2f(0, 0); glEnd();\n"
        "glBegin(GL_POINTS); glColor3f(1, 1, 1); glColor4f(1, 1, 1, 0.25); glVertex2f(0, 0);\n"
        "glColor3f(0.5, 0.5, 0.5); glEnd();");
    EXPECT_EQ(both.state.current_color(), glm::dvec4(0.5, 0.5, 0.5, 1));
    std::array<GLfloat, 4> color{};
    glGetFloatv(GL_CURRENT_COLOR, color.data());
    expect_departure(color[3] == 0.25F);
}

void color_lost_before_a_new_color_material() {
    const Both both(
        "glColor4f(0.1, 0.1, 0.1, 1);\n"
        "glColorMaterial(GL_FRONT, GL_AMBIENT); glEnable(GL_COLOR_MATERIAL); glColor4f(0, 0, 0, 1);\n"
        "GLfloat got[4]; glGetMaterialfv(GL_FRONT, GL_AMBIENT, got);\n"
        "glColor4f(0.5, 0.5, 0.5, 1); glColor4f(1, 1, 1, 1); glColorMaterial(GL_FRONT, GL_DIFFUSE);");
    EXPECT_EQ(both.state.get_material(kGL_FRONT, kGL_AMBIENT), (std::vector<double>{1, 1, 1, 1}));
    std::array<GLfloat, 4> ambient{};
    glGetMaterialfv(GL_FRONT, GL_AMBIENT, ambient.data());
    expect_departure(ambient[0] == 0);
}

constexpr Departure kDepartures[] = {
    {"a single value for a vector parameter", single_value_for_a_vector},
    {"glColor3 after glColor4", alpha_of_glcolor3},
    {"glColor before a new glColorMaterial", color_lost_before_a_new_color_material},
};

TEST(Departures, OfTheStateMachineAreStillThere) {
    for (const Departure& departure : kDepartures) {
        SCOPED_TRACE(departure.name);
        departure.show();
    }
}

// FixedMatchesReference shows that each of the exclusions still differs, fragment_departures_test.cpp its scenes.
TEST(Departures, AreTheOnesOfTheList) {
    std::set<std::string> shown;
    for (const Departure& departure : kDepartures) shown.insert(departure.name);
    for (const Exclusion& exclusion : exclusions()) {
        if (exclusion.departure) shown.emplace(exclusion.name);
    }
    for (const FragmentCase& fragment_case : fragment_cases()) shown.emplace(fragment_case.name);
    EXPECT_EQ(shown, listed_names());
    // What the random states leave out is listed, too.
    for (const FragmentDeparture& departure : fragment_departures()) {
        EXPECT_TRUE(shown.contains(std::string(departure.name))) << departure.name;
    }
}

}  // namespace

}  // namespace twinlight
