#include "app/version.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "render/context/context.h"
#include "render/context/driver_name.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

#ifdef __clang__
constexpr const char* kCompiler = __VERSION__;  // names clang itself
#else
constexpr const char* kCompiler = "g++ " __VERSION__;
#endif

std::string driver_in_use() {
    try {
        const auto context = make_offscreen_context(1, 1);
        return driver_name();
    } catch (const std::runtime_error& error) {
        return "none: " + one_line(error.what());
    }
}

}  // namespace

void add_version_flag(CLI::App& app, const char* program) {
    const auto text = [program] {
        return fmt::format("{} {}\ncommit     {}\ndriver     {}\ncompiler   {}\nlibraries  {}", program, kVersion,
                           *kCommit ? kCommit : "unknown", driver_in_use(), kCompiler, kLibraries);
    };
    app.set_version_flag("--version", text, "Print the versions of the program, the driver and the libraries");
}

}  // namespace twinlight
