// The tutors: five scenes of one idea each, shown with their six calls that matter.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/session.h"
#include "base/image/embedded.h"

namespace twinlight {
extern const std::vector<EmbeddedFile> kTutorFiles;  // NAME.gl for each of kTutors
}

namespace twinlight::session {

struct TutorName {
    std::string_view value, key;  // the same
};
inline constexpr TutorName kTutors[] = {{"light", "light"},
                                        {"material", "material"},
                                        {"normals", "normals"},
                                        {"spot", "spot"},
                                        {"attenuation", "attenuation"}};
// A tutor's scene.
std::string tutor_text(std::string_view tutor);
std::shared_ptr<const CommandList> tutor_scene(std::string_view tutor);
// Opens it in the tutor's view, drawn by the fixed function. Its changes and its undo are kept while others are shown.
void open_tutor(Session& session, std::string_view tutor);
// The tutor after the one on show; at first, the first.
void next_tutor(Session& session);

// The calls that the tutor's view shows, as indexes into the commands: the first six that set lights, materials and normals.
inline constexpr std::size_t kTutorCalls = 6;
std::vector<std::size_t> tutor_calls(const CommandList& commands);

}  // namespace twinlight::session
