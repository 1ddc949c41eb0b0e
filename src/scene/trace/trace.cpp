#include "scene/trace/trace.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

#include "base/text/translation.h"
#include "scene/command/text.h"
#include "scene/trace/apitrace.h"
#include "scene/trace/call_reader.h"
#include "scene/trace/call_stacks.h"
#include "scene/trace/dump_calls.h"
#include "scene/trace/dump_text.h"
#include "scene/trace/temporary_folder.h"
#include "scene/trace/trace_calls.h"

namespace twinlight::trace {

namespace {

[[noreturn]] void refuse(const std::string& name) { throw SceneError(name + ": " + tr(std::strerror(errno))); }

void write_all(const Descriptor& file, std::string_view bytes, const std::string& name) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) refuse(name);
        if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

// Its file is read again for each visit.
class CallRecording : public Recording {
  public:
    void for_each(const std::function<bool(const Step&)>& visit) const override { visit_all(visit); }
    std::vector<std::string> notes() const override { return notes_; }
    std::shared_ptr<const std::string> text_of(const Place& place) const override {
        return place.calls ? sources_.find(*place.file) : nullptr;
    }

  protected:
    CallRecording(std::string given_name, std::string place)
        : Recording(std::move(given_name)), place_(std::move(place)) {}

    virtual std::unique_ptr<CallSource> start() const = 0;
    virtual BlobLoader blobs() const = 0;
    // Returns true if the recording ended.
    bool visit_all(const std::function<bool(const Step&)>& visit) const {
        const std::unique_ptr<CallSource> calls = start();
        CallReader reader(*calls, place_, blobs());
        if (context_) reader.follow(*context_, shown_objects_);
        return reader.for_each(visit);
    }
    void choose_context(std::optional<int> wanted);

    std::string place_;  // its name in places

  private:
    std::optional<ContextName> context_;  // only its calls are visited; nullopt: the calls of all contexts
    std::set<double> shown_objects_;      // framebuffer objects that are read as the window
    std::vector<std::string> notes_;
    mutable SourceTexts sources_;
};

void CallRecording::choose_context(std::optional<int> wanted) {
    const std::unique_ptr<CallSource> calls = start();
    CallReader reader(*calls, place_, blobs());
    ContextCounts counts;
    try {
        reader.count_contexts(wanted.has_value(), counts);
    } catch (const SceneError&) {  // visiting throws it again
    }
    const std::vector<ContextUse>& contexts = counts.contexts();
    if (wanted && *wanted > 0 && static_cast<std::size_t>(*wanted) >= contexts.size()) {
        throw SceneError(tr(
            "{}: the recording has no context {}; {}", place_, *wanted,
            contexts.size() > 1 ? tr("its contexts are 0 to {}", contexts.size() - 1) : tr("its only context is 0")));
    }
    const std::optional<std::size_t> chosen =
        wanted && !contexts.empty() ? std::optional(static_cast<std::size_t>(*wanted)) : counts.busiest();
    if (!chosen) return;
    context_ = contexts[*chosen].name;
    shown_objects_ = contexts[*chosen].shown_objects();
    if (!shown_objects_.empty())
        notes_.emplace_back(
            tr("the program draws into a framebuffer object, as widgets of Qt and GTK do; the picture is what it "
               "shows"));
    if (reader.has_samples(*context_) || (contexts[*chosen].has_samples && contexts[*chosen].draws_to_objects))
        notes_.push_back(tr(kOneSampleNote));
    if (contexts[*chosen].has_elements && !contexts[*chosen].has_buffers)
        notes_.emplace_back(
            tr("apitrace does not record the arrays that glArrayElement takes vertices from, so these may be missing "
               "or wrong; if the program's source is one file, twinlight can read that instead"));
    const bool others_draw = std::ranges::any_of(contexts, [&](const ContextUse& use) {
        return (use.vertices > 0 || use.by_shaders > 0) && use.name != *context_;
    });
    if (!others_draw) return;
    const std::string part = reader.at_end() ? "" : tr("up to call {}, ", reader.call_number());
    notes_.push_back(
        tr("{}{}; this is context {}, --context N chooses another", part, list_of_contexts(contexts), *chosen));
}

// A .trace.
class TraceRecording final : public CallRecording {
  public:
    TraceRecording(std::string given_name, std::string place, Descriptor file, std::optional<int> context, Blobs blobs)
        : CallRecording(std::move(given_name), std::move(place)), file_(std::move(file)), wanted_(blobs) {
        choose_context(context);
    }

  private:
    std::unique_ptr<CallSource> start() const override {
        return std::make_unique<TraceCalls>(TraceFile(file_.get()), place_, wanted_);
    }
    BlobLoader blobs() const override { return wanted_ == Blobs::kAreRead ? blobs_too_large : BlobLoader(); }
    Descriptor file_;
    Blobs wanted_;
};

// A dump in a file or a pipe.
class DumpRecording final : public CallRecording {
  public:
    // A dump in a file.
    DumpRecording(std::string given_name, std::string place, Descriptor file, std::string blobs,
                  std::optional<int> context)
        : CallRecording(std::move(given_name), std::move(place)), folder_(std::move(blobs)) {
        text_.emplace(place_, std::move(file));
        choose_context(context);
    }
    // The dump of a .trace: of the file `trace`, or of `input`.
    DumpRecording(std::string given_name, std::string place, const std::string& trace, const Descriptor& input,
                  std::optional<int> context, Blobs blobs = Blobs::kAreRead)
        : CallRecording(std::move(given_name), std::move(place)),
          leaves_blobs_out_(blobs == Blobs::kAreLeftOut),
          apitrace_(std::in_place, place_, trace, input, blobs) {
        folder_ = apitrace_->folder();
        text_.emplace(place_, nameless_file(), apitrace_->take_output(),
                      [this] { apitrace_error_ = apitrace_->wait(); });
        choose_context(context);
    }
    // A dump from a pipe, of which `front` has already been read.
    DumpRecording(std::string given_name, std::string place, Descriptor pipe, std::string_view front,
                  std::optional<int> context)
        : CallRecording(std::move(given_name), std::move(place)), folder_(".") {
        text_.emplace(place_, nameless_file(), std::move(pipe), std::function<void()>());
        text_->put_in_front(front);
        choose_context(context);
    }

    void for_each(const std::function<bool(const Step&)>& visit) const override {
        bool any = false;
        const bool at_end = visit_all([&](const Step& step) {
            any = true;
            return visit(step);
        });
        if (!at_end || apitrace_error_.empty()) return;
        const std::string error = "apitrace: " + apitrace_error_;
        if (!any) throw SceneError(place_ + ": " + error);
        const Command nowhere{};
        visit({Step::Kind::kCutOff, nowhere, error});
    }

  private:
    std::unique_ptr<CallSource> start() const override {
        return std::make_unique<DumpCalls>(std::make_unique<DumpTextReading>(*text_), place_);
    }
    BlobLoader blobs() const override { return leaves_blobs_out_ ? BlobLoader() : blobs_in_folder(folder_); }

    std::string folder_;  // of the blobs
    bool leaves_blobs_out_ = false;
    std::optional<ApitraceDump> apitrace_;
    mutable std::optional<DumpText> text_;
    mutable std::string apitrace_error_;
};

// A dump in memory.
class TextSource final : public ByteSource {
  public:
    explicit TextSource(std::string_view text) : rest_(text) {}
    std::size_t read(char* to, std::size_t size) override {
        const std::size_t count = rest_.copy(to, size);
        rest_.remove_prefix(count);
        return count;
    }

  private:
    std::string_view rest_;
};

class TextRecording final : public CallRecording {
  public:
    TextRecording(std::string_view text, const std::string& given_name, BlobFiles blobs)
        : CallRecording(given_name, given_name), text_(text), blobs_(std::move(blobs)) {
        choose_context(std::nullopt);
    }

  private:
    std::unique_ptr<CallSource> start() const override {
        return std::make_unique<DumpCalls>(std::make_unique<TextSource>(text_), place_);
    }
    BlobLoader blobs() const override { return blobs_in_memory(blobs_); }

    std::string_view text_;
    BlobFiles blobs_;
};

// A .trace in memory.
class TraceInMemory final : public CallRecording {
  public:
    TraceInMemory(std::string_view bytes, const std::string& given_name)
        : CallRecording(given_name, given_name), bytes_(bytes) {
        choose_context(std::nullopt);
    }

  private:
    std::unique_ptr<CallSource> start() const override {
        return std::make_unique<TraceCalls>(TraceFile(bytes_), place_, Blobs::kAreRead);
    }
    BlobLoader blobs() const override { return blobs_too_large; }

    std::string_view bytes_;
};

std::string_view first_content_line(std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        if (!line.empty() && !line.starts_with("//") && line != "\r") return line;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return {};
}

}  // namespace

bool is_trace(std::string_view front, const std::filesystem::path& path) {
    return is_trace(front) || (path.extension() == ".trace" && !is_dump(front));
}

bool is_trace(std::string_view front) {
    // Either Snappy chunks ("at" and a length, whose bytes are hardly ever all printable), or gzip in older versions.
    const auto printable = [](char c) { return std::isprint(static_cast<unsigned char>(c)) || std::isspace(c); };
    if (front.starts_with("at")) return !std::ranges::all_of(front.substr(0, 16), printable);
    return front.starts_with("\x1f\x8b");
}

bool is_dump(std::string_view front) {
    if (front.starts_with("// process.name = \"")) return true;
    std::string_view line = first_content_line(front);
    while (line.starts_with("\x1b[")) {  // colour codes; DumpReader reports them
        const std::size_t end = line.find('m');
        if (end == std::string_view::npos) return false;
        line.remove_prefix(end + 1);
    }
    // "12 glEnable(", "12 @0 glEnable("
    const auto skip = [&line](auto&& belongs) {
        std::size_t n = 0;
        while (n < line.size() && belongs(static_cast<unsigned char>(line[n]))) ++n;
        line.remove_prefix(n);
        return n > 0;
    };
    const auto is_blank = [](unsigned char c) { return c == ' '; };
    const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
    const auto is_word = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    if (!skip(is_digit) || !skip(is_blank)) return false;
    if (line.starts_with('@')) {
        line.remove_prefix(1);
        if (!skip(is_word) || !skip(is_blank)) return false;
    }
    return skip(is_word) && line.starts_with('(');
}

std::shared_ptr<const Recording> open_trace(const std::string& path, std::optional<int> context, Blobs blobs) {
    const std::string name = one_line(std::filesystem::path(path).filename().string()), place = one_line(path);
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.valid()) refuse(path);
    if (TraceCalls::can_read(TraceFile(file.get())))
        return std::make_shared<TraceRecording>(name, place, std::move(file), context, blobs);
    return std::make_shared<DumpRecording>(name, place, path, Descriptor(), context, blobs);
}

std::shared_ptr<const Recording> open_dump(const std::string& path, std::optional<int> context) {
    const std::filesystem::path file = path;
    Descriptor text(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!text.valid()) refuse(path);
    const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
    return std::make_shared<DumpRecording>(one_line(file.filename().string()), one_line(path), std::move(text), folder,
                                           context);
}

std::shared_ptr<const Recording> read_dump(std::string_view text, const std::string& name, BlobFiles blobs) {
    return std::make_shared<TextRecording>(text, one_line(name), std::move(blobs));
}

std::shared_ptr<const Recording> read_trace(std::string_view bytes, const std::string& name) {
    if (!TraceCalls::can_read(TraceFile(bytes))) return nullptr;
    return std::make_shared<TraceInMemory>(bytes, one_line(name));
}

std::shared_ptr<const Recording> open_standard_input(std::string_view front, std::optional<int> context) {
    const std::string place = "<stdin>";
    Descriptor pipe(::dup(STDIN_FILENO));
    if (!pipe.valid()) refuse(place);
    if (!is_trace(front)) return std::make_shared<DumpRecording>("stdin", place, std::move(pipe), front, context);
    Descriptor file = nameless_file();
    std::string block(front);
    while (!block.empty()) {
        write_all(file, block, place);
        block.resize(kFrontBytes);
        ssize_t count = 0;
        do {
            count = ::read(pipe.get(), block.data(), block.size());
        } while (count < 0 && errno == EINTR);
        if (count < 0) refuse(place);
        block.resize(static_cast<std::size_t>(count));
    }
    if (TraceCalls::can_read(TraceFile(file.get())))
        return std::make_shared<TraceRecording>("stdin", place, std::move(file), context, Blobs::kAreRead);
    return std::make_shared<DumpRecording>("stdin", place, "", file, context);
}

}  // namespace twinlight::trace
