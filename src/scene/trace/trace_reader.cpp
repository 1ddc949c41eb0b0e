#include "scene/trace/trace_reader.h"

#include <algorithm>
#include <cctype>
#include <climits>
#include <cstring>
#include <limits>

#include "base/text/translation.h"
#include "scene/command/text.h"
#include "scene/trace/as_printed.h"

namespace twinlight::trace {

namespace {

using Form = Argument::Form;

constexpr std::uint64_t kFirstVersion = 4, kVersionWithProperties = 6;
constexpr std::size_t kLongestEvent = std::size_t{512} << 20, kMostKept = std::size_t{64} << 20, kMostEntered = 256;
constexpr int kDeepestValue = 64;

}  // namespace

// ---- Events ----

const TraceReader::Call* TraceReader::next() {
    while (failure().empty()) {
        const std::string_view event = rest_;
        try {
            if (read_event()) return returned_.get();
        } catch (const Incomplete&) {
            rest_ = event;
            if (!refill()) return nullptr;
        } catch (const Unreadable&) {
            if (failure_.empty()) failure_ = tr("the file is damaged in call {}", calls_);
        }
    }
    return nullptr;
}

// An event that is longer than a chunk is tried again only with twice the bytes, so the time grows with its length.
bool TraceReader::refill() {
    const std::size_t wanted = 2 * rest_.size() + 1;
    start_ += buffer_.size() - rest_.size();
    buffer_.erase(0, buffer_.size() - rest_.size());
    const std::size_t before = buffer_.size();
    if (before > kLongestEvent) failure_ = tr("call {} is too long", calls_);
    while (buffer_.size() < wanted && file_.read_chunk(buffer_)) {
    }
    rest_ = buffer_;
    return buffer_.size() > before;
}

bool TraceReader::read_cut_chunk() {
    const std::size_t read = buffer_.size() - rest_.size();
    const bool is_cut = file_.read_cut_chunk(buffer_);
    rest_ = std::string_view(buffer_).substr(read);
    return is_cut;
}

const TraceReader::Call* TraceReader::next_unfinished() {
    if (entered_.empty()) return nullptr;
    returned_ = std::move(entered_.front());
    entered_.erase(entered_.begin());
    returned_->arguments.list.assign(1, {Form::kMissing});
    return returned_.get();
}

void TraceReader::read_header() {
    const std::uint64_t version = number();
    if (version < kFirstVersion || version > kVersionWithProperties) {
        is_foreign_ = true;
        failure_ = tr("this is not the format of apitrace 5 to 13");
        throw Unreadable();
    }
    if (version == kVersionWithProperties) {
        number();
        while (!text().empty()) text();
    }
    has_header_ = true;
}

bool TraceReader::read_event() {
    if (!has_header_) {
        read_header();
        return false;
    }
    switch (number()) {
        case 0: enter(); return false;
        case 1: return leave();
        default: throw Unreadable();
    }
}

void TraceReader::enter() {
    if (!spare_) spare_ = std::make_unique<Call>();
    Call& call = *spare_;
    call.thread = static_cast<unsigned>(number());
    const Signature& of = signature();
    call.name = of.name;
    call.function = &of.function;
    call.arguments.clear();
    call.arguments.list.assign(of.arguments, {Form::kMissing});
    call.result.clear();
    call.is_fake = call.has_stack = false;
    call.stack.clear();
    call.text.clear();
    read_details(call);
    std::size_t numbers = call.numbers = call.arguments.numbers.size();
    call.blobs = call.arguments.blobs.size();
    for (const auto& other : entered_) numbers += other->numbers;
    if (entered_.size() >= kMostEntered || numbers > kMaxArrayLength) throw Unreadable();
    call.order = calls_;
    call.number = static_cast<int>(std::min<std::uint64_t>(calls_, std::numeric_limits<int>::max()));
    ++calls_;
    entered_.push_back(std::move(spare_));
}

bool TraceReader::leave() {
    const std::uint64_t order = number();
    const auto found = std::ranges::find(entered_, order, [](const auto& call) { return call->order; });
    if (found == entered_.end()) {
        Call stranger;
        const Function none;
        stranger.function = &none;
        read_details(stranger);
        return false;
    }
    Call& call = **found;
    call.arguments.numbers.resize(call.numbers);  // this may be the second try
    call.arguments.blobs.resize(call.blobs);
    call.result.clear();
    read_details(call);
    spare_ = std::exchange(returned_, std::move(*found));
    entered_.erase(found);
    return true;
}

void TraceReader::read_details(Call& call) {
    enum Detail : std::uint64_t { kEnd, kArgument, kResult, kThread, kStack, kFlags };
    while (true) {
        switch (number()) {
            case kEnd: return;
            case kArgument: read_argument(call); break;
            case kResult: {
                Argument result{Form::kNumber, call.result.numbers.size(), 0};
                read_value(call, call.result, result, 0);
                call.result.list.assign(1, result);
                break;
            }
            case kThread: number(); break;
            case kStack: read_stack(call); break;
            case kFlags: call.is_fake |= (number() & 1) != 0; break;
            default: throw Unreadable();
        }
    }
}

void TraceReader::read_argument(Call& call) {
    const std::uint64_t index = number();
    if (index >= kMostArguments) throw Unreadable();
    std::vector<Argument>& list = call.arguments.list;
    if (index >= list.size()) list.resize(index + 1, {Form::kMissing});
    Argument argument{Form::kNumber, call.arguments.numbers.size(), 0};
    read_value(call, call.arguments, argument, 0);
    list[index] = argument;
}

// ---- Values, in the forms that read_arguments() gives them ----

void TraceReader::add(double number, Arguments& to, Argument& argument) {
    if (to.numbers.size() >= kMaxArrayLength) throw Unreadable();
    to.numbers.push_back(number);
    ++argument.count;
}

void TraceReader::read_value(Call& call, Arguments& to, Argument& argument, int depth) {
    enum Type : std::uint64_t {
        kNull,
        kFalse,
        kTrue,
        kNegative,
        kPositive,
        kFloat,
        kDouble,
        kString,
        kBlob,
        kEnum,
        kBitmask,
        kArray,
        kStructure,
        kPointer,
        kTwoForms,
        kWideString
    };
    if (depth > kDeepestValue) throw Unreadable();
    switch (number()) {
        case kNull: argument.form = depth == 0 ? Form::kNull : Form::kOther; return;
        case kFalse: return add(to.value_of("false", {}), to, argument);
        case kTrue: return add(to.value_of("true", {}), to, argument);
        case kNegative: return add(0.0 - static_cast<double>(number()), to, argument);
        case kPositive:
        case kPointer: return add(static_cast<double>(number()), to, argument);
        case kFloat: {
            float value = 0;
            std::memcpy(&value, bytes(sizeof value).data(), sizeof value);
            return add(as_printed(value), to, argument);
        }
        case kDouble: {
            double value = 0;
            std::memcpy(&value, bytes(sizeof value).data(), sizeof value);
            return add(as_printed(value), to, argument);
        }
        case kString: {
            const std::string_view string = text();
            if (call.function->is_mark) call.text = string.substr(0, kLongestStack);
            argument.form = Form::kOther;
            return;
        }
        case kBlob: return read_blob(call, to, argument);
        case kEnum: return add(read_enumerant(to), to, argument);
        case kBitmask: return add(read_bitmask(to), to, argument);
        case kArray: return read_array(call, to, argument, depth);
        case kStructure: return read_structure(call, to, argument, depth);
        case kTwoForms: {  // for people, and for machines
            read_value(call, to, argument, depth + 1);
            Arguments ignored;
            Argument second;
            return read_value(call, ignored, second, depth + 1);
        }
        case kWideString:
            for (std::uint64_t left = number(); left > 0; --left) number();
            argument.form = Form::kOther;
            return;
        default: throw Unreadable();
    }
}

double TraceReader::read_enumerant(Arguments& to) {
    const auto [enumeration, is_new] = described(enumerations_);
    if (is_new) {
        for (std::uint64_t left = number(); left > 0; --left) {
            Name of = name();
            enumeration.names.try_emplace(whole(), std::move(of));
        }
    }
    const std::int64_t value = whole();
    const auto found = enumeration.names.find(value);
    return found == enumeration.names.end() ? static_cast<double>(value)
                                            : to.value_of(found->second.name, found->second.known);
}

double TraceReader::read_bitmask(Arguments& to) {
    const auto [mask, is_new] = described(bitmasks_);
    if (is_new) {
        mask.flags.clear();
        for (std::uint64_t left = number(); left > 0; --left) {
            Name of = name();
            mask.flags.emplace_back(number(), std::move(of));
        }
    }
    std::uint64_t left = number(), value = 0;
    for (const auto& [bits, of] : mask.flags) {
        if (bits != 0 ? (left & bits) != bits : left != 0 || value != 0) continue;
        value |= static_cast<std::uint64_t>(to.value_of(of.name, of.known));
        left &= ~bits;
        if (left == 0) break;
    }
    return static_cast<double>(value | left);
}

void TraceReader::read_array(Call& call, Arguments& to, Argument& argument, int depth) {
    const std::uint64_t count = number();
    Form form = Form::kArray;
    for (std::uint64_t i = 0; i < count; ++i) {
        argument.form = Form::kNumber;
        read_value(call, to, argument, depth + 1);
        // One element is printed as what a pointer points to.
        const bool fits = argument.form == Form::kNumber || (argument.form == Form::kArray && count > 1);
        if (!fits) form = Form::kOther;
    }
    argument.form = form;
}

void TraceReader::read_structure(Call& call, Arguments& to, Argument& argument, int depth) {
    const auto [structure, is_new] = described(structures_);
    if (is_new) {
        text();
        structure.members = number();
        for (std::uint64_t left = structure.members; left > 0; --left) text();
    }
    for (std::uint64_t left = structure.members; left > 0; --left) read_value(call, to, argument, depth + 1);
    argument.form = structure.members > 0 ? Form::kOther : Form::kArray;
}

// Memory of calls that set or draw nothing is not kept.
void TraceReader::read_blob(const Call& call, Arguments& to, Argument& argument) {
    const std::string_view memory = text();
    const Role role = call.function->role;
    if (!wants_blobs_ || (role != Role::kCommand && role != Role::kCopy)) {
        argument.form = Form::kBlobSize;
        return;
    }
    if (to.blobs.size() >= kMostBlobs) throw Unreadable();
    argument = {Form::kBlob, to.blobs.size(), 1};
    Blob blob{tr("of {} bytes", memory.size())};
    if (budget_.allows(memory.size())) {
        const std::shared_ptr<Memory> copy = budget_.allocate(memory.size());
        if (!memory.empty()) std::memcpy(copy->bytes.data(), memory.data(), memory.size());
        blob.memory = copy;
    }
    to.blobs.push_back(std::move(blob));
}

// ---- What has a number ----

template <class Of>
std::pair<Of&, bool> TraceReader::described(std::unordered_map<std::uint64_t, Of>& all) {
    const std::uint64_t here = position();
    const auto [found, is_new] = all.try_emplace(number());
    if (is_new) {
        keep(sizeof(Of));
        found->second.at = here;
    }
    return {found->second, found->second.at == here};
}

void TraceReader::keep(std::size_t bytes) {
    kept_ += bytes;
    if (kept_ > kMostKept) throw Unreadable();
}

std::string TraceReader::kept_text() {
    const std::string_view found = text();
    keep(found.size());
    return std::string(found);
}

TraceReader::Name TraceReader::name() {
    keep(sizeof(Name));
    Name name{kept_text(), {}};
    name.known = known_value(name.name);
    return name;
}

const TraceReader::Signature& TraceReader::signature() {
    const auto [signature, is_new] = described(signatures_);
    if (is_new) {
        signature.name = kept_text();
        const auto is_printed = [](char c) { return std::isgraph(static_cast<unsigned char>(c)) != 0; };
        if (signature.name.empty() || !std::ranges::all_of(signature.name, is_printed)) throw Unreadable();
        signature.function = functions_.find(signature.name);
        const std::uint64_t arguments = number();
        if (arguments > kMostArguments) throw Unreadable();
        signature.arguments = static_cast<std::size_t>(arguments);
        for (std::uint64_t left = arguments; left > 0; --left) text();
    }
    return signature;
}

void TraceReader::read_stack(Call& call) {
    enum Detail : std::uint64_t { kEnd, kModule, kFunction, kFile, kLine, kOffset };
    call.has_stack = true;
    call.stack.clear();
    for (std::uint64_t left = number(); left > 0; --left) {
        const char* const start = rest_.data();
        const auto [frame, is_new] = described(frames_);
        if (call.stack.size() < kLongestStack) call.stack.append(start, rest_.data());
        if (!is_new) continue;
        for (bool goes_on = true; goes_on;) {
            switch (number()) {
                case kEnd: goes_on = false; break;
                case kModule: frame.module = kept_text(); break;
                case kFunction: frame.function = kept_text(); break;
                case kFile: frame.file = kept_text(); break;
                case kLine: frame.line = static_cast<int>(std::min<std::uint64_t>(number(), INT_MAX)); break;
                case kOffset: number(); break;
                default: throw Unreadable();
            }
        }
    }
}

std::vector<CallFrame> TraceReader::frames(std::string_view stack) const {
    std::vector<CallFrame> found;
    while (const auto id = take_number(stack)) {
        const auto frame = frames_.find(*id);
        if (frame == frames_.end()) continue;
        const StackFrame& of = frame->second;
        found.push_back({of.module, of.function, of.file, of.line});
    }
    return found;
}

// ---- Bytes ----

std::uint64_t TraceReader::number() {
    const auto value = take_number(rest_);
    if (value) return *value;
    if (!rest_.empty()) throw Unreadable();
    throw Incomplete();
}

std::int64_t TraceReader::whole() {
    const std::uint64_t sign = number();
    if (sign != 3 && sign != 4) throw Unreadable();
    const auto value = static_cast<std::int64_t>(number() & std::numeric_limits<std::int64_t>::max());
    return sign == 3 ? -value : value;
}

std::string_view TraceReader::bytes(std::uint64_t count) {
    if (count > kLongestEvent) throw Unreadable();
    if (count > rest_.size()) throw Incomplete();
    const std::string_view found = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return found;
}

}  // namespace twinlight::trace
