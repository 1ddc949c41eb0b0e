#include "app/program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <sstream>
#include <utility>
#include <vector>

#include "app/crash_report.h"
#include "base/image/file.h"
#include "base/text/input_text.h"
#include "render/context/context.h"
#include "render/programmable/shader_program.h"
#include "scene/command/names.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

// `text` as a side's length, or 0 if it is not one.
int parse_side(std::string_view text) {
    int side = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && side >= kMinSide && side <= kMaxSide ? side : 0;
}

// For a misspelt option, CLI11 would report that the right one is missing, or an unexpected argument.
void check_option_names(const CLI::App& command, const std::string& name_of_command, int argc, char** argv) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--") return;
        const bool is_long = word.starts_with("--");
        const bool is_short = word.starts_with('-') && word.size() > 1;
        if (!is_long && !is_short) continue;
        const std::string name(is_long ? word.substr(0, word.find('=')) : word.substr(0, 2));
        if (std::ranges::find(names, name) != names.end()) continue;
        // No suggestion for options of one letter: all of them are similar.
        const auto near = is_long ? nearest(name, {names.begin(), names.end()}) : std::nullopt;
        throw UsageError(
            fmt::format("there is no option '{}'; {}", name,
                        near ? fmt::format("did you mean '{}'?", *near) : "see '" + name_of_command + " --help'"));
    }
}

// CLI11's message, or a plainer one for a wrong number of arguments.
std::string message_of(const CLI::App& command, const CLI::ParseError& error) {
    if (dynamic_cast<const CLI::ExtrasError*>(&error)) {
        return fmt::format("unexpected argument '{}'", command.remaining().front());
    }
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
        const std::string_view what = error.what();
        const std::string name(what.substr(0, what.find(':')));
        if (const CLI::Option* option = command.get_option_no_throw(name)) {
            return name + (option->count() > 1 ? " is given more than once" : " needs a value");
        }
    }
    return error.what();
}

// Writes a refused shader to a temporary file: "; its text is in FILE", or nothing if that fails.
std::string where_kept(std::string_view text) {
    std::error_code error;
    std::string file = (std::filesystem::temp_directory_path(error) / "twinlight-refused-XXXXXX").string();
    const int descriptor = error ? -1 : ::mkstemp(file.data());
    if (descriptor < 0) return "";
    const bool written = ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    ::close(descriptor);
    return written ? "; its text is in " + one_line(file) : "";
}

// Needs no memory itself.
std::string_view running_program;
void report_no_memory() {
    for (const std::string_view part : {running_program, std::string_view(": out of memory; try a smaller --size\n")}) {
        [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, part.data(), part.size());
    }
}

// A destructor that needs memory cannot throw: nlohmann::json's is one.
std::terminate_handler terminate_before = nullptr;
void end_without_memory() {
    try {
        if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        report_no_memory();
        ::_exit(kBadInput);
    } catch (...) {  // the handler before prints it
    }
    terminate_before();
}

}  // namespace

Size parse_size(const std::string& text) {
    const std::size_t x = text.find('x');
    if (x != std::string::npos) {
        const std::string_view view = text;
        const Size size = {.width = parse_side(view.substr(0, x)), .height = parse_side(view.substr(x + 1))};
        if (size.width != 0 && size.height != 0) return size;
    }
    throw CLI::ValidationError("--size", fmt::format("'{}' is not a size; it must be WxH, from {}x{} to {}x{}", text,
                                                     kMinSide, kMinSide, kMaxSide, kMaxSide));
}

void add_size_option(CLI::App& app, Size& size) {
    app.add_option_function<std::string>(
           "--size", [&size](const std::string& text) { size = parse_size(text); }, "picture size in pixels")
        ->type_name("WxH")
        ->default_str(fmt::format("{}x{}", size.width, size.height));
}

void add_size_option(CLI::App& app, std::optional<Size>& size, const std::string& default_size) {
    app.add_option_function<std::string>(
           "--size", [&size](const std::string& text) { size = parse_size(text); },
           "picture size in pixels (default: " + default_size + ")")
        ->type_name("WxH");
}

void add_language_option(CLI::App& app, lesson::Language& language, const std::string& what) {
    app.add_option_function<std::string>(
           "--language",
           [&language](const std::string& name) {
               const auto found = lesson::find_language(name);
               if (!found) throw CLI::ValidationError("--language", "'" + name + "' is not one of en, zh");
               language = *found;
           },
           what)
        ->type_name("en|zh");
}

CLI::Validator not_empty() {
    return CLI::Validator([](const std::string& text) { return text.empty() ? "the name is empty" : ""; }, "");
}

namespace {

// --help of every release of CLI11: their own formatters (2.1, 2.4, 2.6) differ in headings, columns and line breaks.
class HelpText : public CLI::Formatter {
  public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const override {
        std::string text = fmt::format("{}\nUsage: {}", app->get_description(), name);
        const auto options = app->get_options([](const CLI::Option* option) { return option->nonpositional(); });
        const auto positionals = app->get_options([](const CLI::Option* option) { return option->get_positional(); });
        const auto commands = app->get_subcommands([](const CLI::App*) { return true; });
        if (!options.empty()) text += " [OPTIONS]";
        for (const CLI::Option* one : positionals) text += " " + make_option_usage(one);
        if (!commands.empty()) text += " SUBCOMMAND";
        text += "\n";
        add_options(text, "Positionals", positionals);
        add_options(text, "Options", options);
        if (!commands.empty()) text += "\nSubcommands:\n";
        for (const CLI::App* command : commands) add_row(text, command->get_name(), command->get_description());
        return text + "\n" + (app->get_footer().empty() ? "" : app->get_footer() + "\n");
    }

  private:
    static constexpr std::size_t kColumn = 30;

    static void add_row(std::string& text, const std::string& left, const std::string& description) {
        const std::string name = "  " + left, indent(kColumn, ' ');
        text += fmt::format("{:<{}}", name, kColumn);
        if (!description.empty() && name.size() >= kColumn) text += "\n" + indent;
        for (const char c : description) {
            text += c;
            if (c == '\n') text += indent;
        }
        text += '\n';
    }
    static std::string value_of(const CLI::Option& option) {
        if (!option.get_option_text().empty()) return " " + option.get_option_text();
        if (option.get_type_size() == 0) return "";
        std::string text = option.get_type_name().empty() ? "" : " " + option.get_type_name();
        if (!option.get_default_str().empty()) text += "=" + option.get_default_str();
        if (option.get_expected_max() == CLI::detail::expected_max_vector_size) text += " ...";
        if (option.get_required()) text += " REQUIRED";
        return text;
    }
    static void add_options(std::string& text, std::string_view heading,
                            const std::vector<const CLI::Option*>& options) {
        if (!options.empty()) text += fmt::format("\n{}:\n", heading);
        for (const CLI::Option* option : options)
            add_row(text, option->get_name(option->get_positional(), !option->get_positional()) + value_of(*option),
                    option->get_description());
    }
};

}  // namespace

bool parse_command_line(CLI::App& app, int argc, char** argv) {
    const auto help = std::make_shared<HelpText>();
    app.formatter(help);
    for (CLI::App* command : app.get_subcommands({})) command->formatter(help);
    try {
        app.parse(argc, argv);
        return true;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            std::ostringstream text;            // --help or --version
            text.exceptions(std::ios::badbit);  // when memory is short
            app.exit(error, text, text);
            write_result(text.str());
            return false;
        }
        const std::vector<CLI::App*> subcommands = app.get_subcommands();
        const CLI::App& command = subcommands.empty() ? app : *subcommands.front();
        const std::string name = app.get_name() + (subcommands.empty() ? "" : " " + command.get_name());
        const bool of_a_value = dynamic_cast<const CLI::ValidationError*>(&error) != nullptr;
        if (!of_a_value) check_option_names(command, name, argc, argv);
        throw UsageError(fmt::format("{}; see '{} --help'", message_of(command, error), name));
    }
}

void write_output(const std::string& file, std::string_view bytes) {
    if (file == "-")
        write_result(bytes);
    else
        write_file_atomically(file, bytes);
}

namespace {

lesson::Lesson lesson_of_file(const std::string& file, lesson::Language language) {
    constexpr std::size_t kMostBytes = 1U << 20;
    const std::filesystem::path path = file;
    const std::string folder = path.parent_path().empty() ? "." : path.parent_path().string();
    const std::string text = read_file(file, kMostBytes);
    try {
        lesson::Lesson lesson = lesson::read_lesson(text, path.stem().string(), folder);
        lesson.language = language;
        return lesson;
    } catch (const std::runtime_error& error) {
        throw FileError((path.parent_path() / error.what()).string());
    }
}

}  // namespace

lesson::Lesson load_lesson(const std::string& name, lesson::Language language) {
    if (extension_of(name) == ".md") return lesson_of_file(name, language);
    const auto names = lesson::names();
    if (std::ranges::find(names, name) == names.end()) {
        const auto near = nearest(name, {names.begin(), names.end()});
        throw UsageError(
            fmt::format("there is no lesson '{}'; {}", name,
                        near ? fmt::format("did you mean '{}'?", *near) : "'twinlight lesson' lists the lessons"));
    }
    return lesson::load_lesson(name, language);
}

int run_reporting_errors(std::string_view program, const std::function<int()>& run) {
    const auto fail = [](const std::string& message) {
        print_message("{}\n", message);
        return kBadInput;
    };
    running_program = program;
    terminate_before = std::set_terminate(end_without_memory);
    prepare_streams();
    try {
        report_crashes(program);
        keep_freed_memory();
        return run();
    } catch (const SceneError& error) {  // begins with the place, for editors to jump to
        write_message(as_compilers_print(error));
        return kBadInput;
    } catch (const std::bad_alloc&) {
        report_no_memory();
        return kBadInput;
    } catch (const UsageError& error) {
        return fail(fmt::format("{}: {}", program, one_line(error.what())));
    } catch (const FileError& error) {
        return fail(fmt::format("{}: {}", program, one_line(error.what())));
    } catch (const programmable::ShaderRefused& error) {
        return fail(fmt::format("{}: {}{}", program, one_line(error.what()),
                                error.text.empty() ? "; --with reference draws them" : where_kept(error.text)));
    } catch (const std::exception& error) {  // errors of the driver may have several lines
        std::string lines;
        InputText text(error.what());
        for (std::string line; std::getline(text, line);) lines += (lines.empty() ? "" : "\n") + one_line(line);
        return fail(fmt::format("{}: {}", program, lines));
    }
}

}  // namespace twinlight
