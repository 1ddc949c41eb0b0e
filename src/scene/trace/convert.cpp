#include "scene/trace/convert.h"

#include <fmt/format.h>

#include <cmath>

#include "base/math/as_float.h"
#include "base/text/translation.h"
#include "scene/command/lexer.h"
#include "scene/command/memory.h"
#include "scene/command/object_names.h"
#include "scene/command/text.h"

namespace twinlight::trace {

namespace {

using Form = Argument::Form;

template <class... Values>
[[noreturn]] void refuse(const Command& command, const Parameter& parameter, fmt::format_string<Values...> what,
                         Values&&... values) {
    fail(command.place, "{} of {} {}", parameter.name, command.name(), vtr(what, fmt::make_format_args(values...)));
}

// The value converted to the C type of the parameter.
double typed(const Command& command, const Parameter& parameter, double value) {
    if (parameter.kind == Kind::kFloat) return as_float(value);
    if (parameter.kind == Kind::kDouble) return value;
    // apitrace may print an unknown enumerant as a negative number.
    const bool wraps = parameter.kind == Kind::kEnum || parameter.kind == Kind::kBitfield;
    if (wraps && value < 0 && value >= -2147483648.0) value += 4294967296.0;
    if (value != std::trunc(value)) refuse(command, parameter, "must be a whole number, not {}", value);
    const auto [smallest, largest] = whole_range(parameter.kind);
    if (value < smallest || value > largest)
        refuse(command, parameter, "is {}; it must be from {} to {}", value, smallest, largest);
    return value;
}

// How many values an array needs; nullopt if any number is allowed, as for an unknown pname.
std::optional<std::size_t> length_of(const Command& command, const Parameter& parameter) {
    if (parameter.extent == Extent::kArrayByPname) {
        const auto length = array_length(command.id, command.enumerant(command.arguments.size() - 1));
        return length ? std::optional(static_cast<std::size_t>(*length)) : std::nullopt;
    }
    return command.count(static_cast<std::size_t>(&parameter - command.sig().parameters.data()));
}

void add_array(const Argument& argument, const Arguments& arguments, const Parameter& parameter, Command& command) {
    if (argument.form != Form::kArray && argument.form != Form::kNull) refuse(command, parameter, "is not an array");
    const std::optional<std::size_t> needed = length_of(command, parameter);
    std::size_t count = argument.form == Form::kNull ? 0 : argument.count;
    if (needed && count < *needed) {
        // Some commands with a fixed length in the table have pnames that need fewer values (glTexGenfv).
        const bool has_pname = &parameter != command.sig().parameters.data() && (&parameter - 1)->name == "pname";
        if (parameter.extent != Extent::kArray || !has_pname || count == 0)
            refuse(command, parameter, "has {} values, but {} are needed", count, *needed);
    }
    count = std::min(count, needed.value_or(count));
    for (std::size_t i = 0; i < count; ++i)
        command.arguments.push_back(typed(command, parameter, arguments.numbers[argument.first + i]));
    if (needed) command.arguments.resize(command.arguments.size() + *needed - count);
}

void add_pointer(const Argument& argument, const Arguments& arguments, const Parameter& parameter,
                 const BlobLoader& blobs, Command& command) {
    switch (argument.form) {
        case Form::kNull: command.arguments.push_back(0); return;
        case Form::kNumber:  // an offset into a buffer object
            command.arguments.push_back(typed(command, parameter, arguments.numbers[argument.first]));
            return;
        case Form::kBlob: {
            const Blob& blob = arguments.blobs[argument.first];
            command.memory = blob.memory ? blob.memory : blobs(blob.name, command.place);
            command.arguments.push_back(0);
            return;
        }
        case Form::kBlobSize:
            if (!blobs) {
                command.arguments.push_back(0);
                return;
            }
            refuse(command, parameter, "is not in this dump; create the dump with 'apitrace dump --blobs'");
        case Form::kArray:
        case Form::kOther:
        case Form::kMissing: refuse(command, parameter, "is neither a blob nor an offset");
    }
}

}  // namespace

void convert(const Arguments& arguments, const Arguments& result, const BlobLoader& blobs, Command& command) {
    const Signature& sig = command.sig();
    command.arguments.clear();
    command.memory.reset();
    const std::size_t expected = sig.c_arguments();
    if (arguments.list.size() != expected) {
        fail(command.place, "{} takes {} arguments: {}; this call has {}", sig.name, expected, sig.usage(),
             arguments.list.size());
    }
    for (std::size_t i = 0; i < expected; ++i) {
        const Parameter& parameter = sig.parameters[i];
        const Argument& argument = arguments.list[i];
        if (parameter.extent == Extent::kValue) {
            if (argument.form != Form::kNumber) refuse(command, parameter, "is not a number");
            command.arguments.push_back(typed(command, parameter, arguments.numbers[argument.first]));
        } else if (parameter.extent == Extent::kPointer) {
            add_pointer(argument, arguments, parameter, blobs, command);
        } else if (parameter.extent == Extent::kOutputMemory) {
            command.arguments.push_back(0);
        } else if (parameter.is_array() && !parameter.is_output()) {
            add_array(argument, arguments, parameter, command);
        }
    }
    if (expected == sig.parameters.size()) return;
    const Parameter& returned = sig.parameters.back();
    if (!named_objects(returned)) {  // the program has already used it
        command.arguments.push_back(0);
        return;
    }
    const bool is_number = !result.list.empty() && result.list[0].form == Form::kNumber;
    if (!is_number) refuse(command, returned, "is missing: this dump does not have the result of the call");
    command.arguments.push_back(typed(command, returned, result.numbers[0]));
}

}  // namespace twinlight::trace
