// Reads the calls of a .trace: events inside the chunks of its file (apitrace's docs/FORMAT.markdown; lib/trace/trace_parser.cpp).
// A call is two events: the program enters it, with its arguments, and leaves it, with its result. Names, such as those of a
// function or of an enumerant, are given once and have a number from then on.
//
// The file may be damaged, or made to do harm: every length and count is checked, and the memory is bounded.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scene/trace/blobs.h"
#include "scene/trace/call_source.h"
#include "scene/trace/trace_file.h"

namespace twinlight::trace {

class TraceReader {
  public:
    struct Call : RecordedCall {
        std::uint64_t order = 0;  // its number, of any size
        std::string text{};       // of a mark
        // When it was entered.
        std::size_t numbers = 0, blobs = 0;
    };

    // `file` must exist as long as the reader.
    TraceReader(TraceFile& file, Blobs blobs) : file_(file), wants_blobs_(blobs == Blobs::kAreRead) {}

    // The next call that has returned, valid until the next one. Null if the file has no more, though it may grow, or cannot be read.
    const Call* next();
    // At the end: the calls that have not returned, one after the other.
    const Call* next_unfinished();
    // At the end: reads on if the file ends within a chunk. Returns false if it does not.
    bool read_cut_chunk();

    std::uint64_t calls() const { return calls_; }  // that were entered
    // Why no more can be read; "" if the file is in order so far.
    const std::string& failure() const { return file_.failure().empty() ? failure_ : file_.failure(); }
    // The file is of a kind or version that this cannot read.
    bool is_foreign() const { return is_foreign_ || file_.is_foreign(); }
    // Where the last event ends, in uncompressed bytes.
    std::uint64_t position() const { return start_ + buffer_.size() - rest_.size(); }
    // The frames of Call::stack.
    std::vector<CallFrame> frames(std::string_view stack) const;

  private:
    struct Incomplete {};  // the event goes on in the next chunk
    struct Unreadable {};

    // What has a number. Its description follows the number where that comes first.
    struct Described {
        std::uint64_t at = 0;  // the position there
    };
    struct Signature : Described {
        std::string name;
        Function function;
        std::size_t arguments = 0;
    };
    struct Structure : Described {
        std::uint64_t members = 0;
    };
    struct Name {
        std::string name;
        std::optional<Enum> known;
    };
    struct Enumeration : Described {
        std::unordered_map<std::int64_t, Name> names;
    };
    struct Bitmask : Described {
        std::vector<std::pair<std::uint64_t, Name>> flags;
    };
    struct StackFrame : Described {
        std::string module, function, file;
        int line = 0;
    };

    bool refill();
    void read_header();
    bool read_event();  // returns whether a call has returned
    void enter();
    bool leave();
    void read_details(Call& call);
    void read_argument(Call& call);
    void read_stack(Call& call);
    void read_value(Call& call, Arguments& to, Argument& argument, int depth);
    double read_enumerant(Arguments& to);
    double read_bitmask(Arguments& to);
    void read_array(Call& call, Arguments& to, Argument& argument, int depth);
    void read_structure(Call& call, Arguments& to, Argument& argument, int depth);
    void read_blob(const Call& call, Arguments& to, Argument& argument);
    void add(double number, Arguments& to, Argument& argument);
    const Signature& signature();

    std::uint64_t number();
    std::int64_t whole();  // with its sign
    std::string_view bytes(std::uint64_t count);
    std::string_view text() { return bytes(number()); }
    std::string kept_text();
    Name name();
    // Looks up a number, and whether its description follows.
    template <class Of>
    std::pair<Of&, bool> described(std::unordered_map<std::uint64_t, Of>& all);
    void keep(std::size_t bytes);  // counts what descriptions hold

    TraceFile& file_;
    bool wants_blobs_;
    BlobBudget budget_{};
    std::string buffer_, failure_;
    std::string_view rest_{};  // the bytes of buffer_ that are not read yet
    std::uint64_t start_ = 0;  // of buffer_ among all uncompressed bytes
    bool has_header_ = false, is_foreign_ = false;

    std::unordered_map<std::uint64_t, Signature> signatures_;
    std::unordered_map<std::uint64_t, Structure> structures_;
    std::unordered_map<std::uint64_t, Enumeration> enumerations_;
    std::unordered_map<std::uint64_t, Bitmask> bitmasks_;
    std::unordered_map<std::uint64_t, StackFrame> frames_;
    std::size_t kept_ = 0;
    FunctionTable functions_;
    std::uint64_t calls_ = 0;
    std::vector<std::unique_ptr<Call>> entered_;
    std::unique_ptr<Call> returned_, spare_ = std::make_unique<Call>();
};

}  // namespace twinlight::trace
