// Reads the arguments of a call as the table of commands describes them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "scene/command/memory.h"
#include "scene/command/mesh.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

// Reads the arguments after "(" and the ")".
void Reader::arguments(Command& command, const Signature& sig) {
    const std::size_t wanted = sig.c_arguments();
    const auto wrong_count = [&](const Place& place, std::string_view found) {
        fail(place, "{} takes {}: {}; {}", sig.name, arguments_text(wanted), sig.usage(), found);
    };
    std::size_t given = 0;
    for (; given < wanted; ++given) {
        if (sig.parameters[given].extent == Extent::kRest) {
            rest_arguments(command, sig.parameters[given]);
            break;
        }
        if (given > 0 && !token_.is(")")) expect(",", "between the arguments of {}", sig.name);
        if (token_.is(")"))
            wrong_count(token_.place, given == 1 ? tr("only 1 is given") : tr("only {} are given", given));
        argument(command, given);
    }
    if (token_.is(",")) wrong_count(token_.place, tr("more are given"));
    expect(")", "after the arguments of {}", sig.name);
    if (wanted < sig.parameters.size())
        command.arguments.push_back(result(command, sig.parameters.back()));
    else if (returns_)
        fail(returns_place_, "returns(...) must come before a call that returns a value; the next call is {}",
             sig.name);
}

void Reader::argument(Command& command, std::size_t i) {
    const Parameter& parameter = command.sig().parameters[i];
    if (parameter.is_array()) return array_argument(command, i);
    if (parameter.extent == Extent::kPointer) return pointer_argument(command, parameter);
    if (parameter.extent == Extent::kOutputMemory) return written_argument(command, parameter);
    if (parameter.extent == Extent::kImage) return image_argument(command);
    if (parameter.extent == Extent::kMesh) return mesh_argument(command);
    if (parameter.extent == Extent::kText) return text_argument(command, parameter);
    if (parameter.kind == Kind::kWord) {
        command.arguments.push_back(word_argument(command, parameter));
        return;
    }
    if (parameter.kind == Kind::kQuadric) {
        command.arguments.push_back(quadric_argument(command));
        return;
    }
    const Place place = token_.place;
    command.arguments.push_back(converted(number(), parameter.kind, place,
                                          [&] { return tr("the argument {} of {}", parameter.name, command.name()); }));
}

void Reader::rest_arguments(Command& command, const Parameter& parameter) {
    const bool is_first = command.arguments.empty();
    for (std::size_t given = 0; given > 0 || !is_first ? accept(",") : !token_.is(")"); ++given) {
        const Place place = token_.place;
        if (given >= kMaxArrayLength) fail(place, "too many arguments");
        command.arguments.push_back(converted(number(), parameter.kind, place, [&] {
            return tr("the argument {} of {}", parameter.name, command.name());
        }));
    }
}

namespace {

// The words that a pragma takes, for messages; empty where it takes the name of a spectrum.
std::vector<std::string_view> words_for(CommandId pragma) {
    const auto names = [](std::initializer_list<Word> few) {
        std::vector<std::string_view> all;
        for (Word word : few) all.push_back(word_name(word));
        return all;
    };
    switch (pragma) {
        case CommandId::pragma_specular: return names({Word::half_vector, Word::reflection});
        case CommandId::pragma_ambient: return names({Word::attenuated, Word::unattenuated});
        case CommandId::pragma_transfer: return names({Word::linear, Word::srgb});
        case CommandId::pragma_shape:
            return names({Word::cube, Word::cylinder, Word::cylinder_triangles, Word::cone, Word::sphere});
        default: return {};
    }
}

}  // namespace

double Reader::word_argument(const Command& command, const Parameter& parameter) {
    const std::optional<Enum> word = token_.kind == TokenKind::kName ? find_word(token_.text) : std::nullopt;
    if (!word) {
        std::vector<std::string_view> names = words_for(command.id);
        const std::string expected = names.empty() ? tr("a {} from docs/scene-language.md", parameter.name)
                                                   : tr("one of {}", fmt::join(names, ", "));
        if (names.empty())
            for (const NamedValue& known : words()) names.push_back(known.name);
        const auto near = nearest(token_.text, names);
        fail(token_.place, "expected {}, found {}{}", expected, shown(token_), did_you_mean(near));
    }
    advance();
    return *word;
}

// Reads an array, a place in an array, NULL, or an offset into a buffer object: (const void*)12.
void Reader::pointer_argument(Command& command, const Parameter& parameter) {
    const Token start = token_;
    const Value given = expression();
    if (!given.is_pointer() && !(given.is_integer() && given.integer == 0)) {
        fail(start.place,
             "the argument {} of {} must be an array, NULL, or an offset into a buffer object such as (const void*)12",
             parameter.name, command.name());
    }
    if (given.object) {
        if (!given.object->memory) fail(start.place, "this memory was freed");
        check_known(*given.object, static_cast<std::size_t>(given.offset), kMaxMemoryBytes, start.place);
        command.memory = given.object->memory;
    }
    command.arguments.push_back(static_cast<double>(given.offset));
}

// Reads the name of a picture in the scene's folder, "brick.png". Each picture is loaded once, even if it is named
// again.
void Reader::image_argument(Command& command) {
    const Token name = token_;
    if (name.kind != TokenKind::kString)
        fail(name.place, "expected the name of a picture in quotes, such as \"brick.png\", found {}", shown(name));
    advance();
    const std::string file(name.text.substr(1, name.text.size() - 2));
    auto found = images_.find(file);
    if (found == images_.end()) {
        try {
            ImageFile image = load_image_(file);
            if (image.rgba.size() > kMaxMemoryBytes - bytes_) {
                throw std::runtime_error(
                    tr("all arrays and pictures of a scene together can have at most {} MiB", kMaxMemoryBytes >> 20));
            }
            bytes_ += image.rgba.size();
            auto memory = std::make_shared<const Memory>(Memory{Kind::kUbyte, std::move(image.rgba), file});
            found = images_.emplace(file, LoadedImage{image.width, image.height, std::move(memory)}).first;
        } catch (const std::runtime_error& error) {
            fail(name.place, "{}: {}", in_quotes(file), error.what());
        }
    }
    command.arguments.push_back(found->second.width);
    command.arguments.push_back(found->second.height);
    command.memory = found->second.memory;
}

void Reader::mesh_argument(Command& command) {
    const Token name = token_;
    if (name.kind != TokenKind::kString)
        fail(name.place, "expected the name of an OBJ file in quotes, such as \"bunny.obj\", found {}", shown(name));
    advance();
    const std::string file(name.text.substr(1, name.text.size() - 2));
    std::shared_ptr<const Memory>& memory = meshes_[file];
    if (!memory) {
        try {
            auto mesh = load_mesh_(file);
            hold(mesh->bytes(), name.place);
            memory = std::make_shared<const Memory>(Memory{Kind::kUbyte, {}, file, std::move(mesh)});
        } catch (const SceneError&) {
            throw;
        } catch (const std::runtime_error& error) {
            fail(name.place, "{}: {}", in_quotes(file), error.what());
        }
    }
    command.arguments.push_back(static_cast<double>(memory->mesh->vertex_count()));
    command.arguments.push_back(static_cast<double>(memory->mesh->triangle_count()));
    command.memory = memory;
}

namespace {

// For messages: "glLightfv with GL_POSITION".
std::string with_pname(std::string_view name, std::optional<Enum> pname) {
    for (const NamedValue& row : gl_names())
        if (pname && row.value == *pname) return tr("{} with {}", name, row.name);
    return std::string(name);
}

// For messages: what to add to an array of three values where the command reads four.
std::string_view fourth_value(const Command& command, std::optional<Enum> pname) {
    const std::optional<Owner> owner = owner_of(command.id);
    const ParameterInfo* info = owner && pname ? find_parameter(*owner, *pname) : nullptr;
    if (!info || info->count != 4) return "";
    if (info->meaning == Meaning::kPosition) return tr("; add a fourth value w: 1 for a place, 0 for a direction");
    return info->meaning == Meaning::kColor ? tr("; add a fourth value, alpha: 1 for an opaque colour") : "";
}

// Marks the object's values as unknown, because the command writes to it.
void forget_values(Object& object, std::size_t from, std::size_t to, const Command& command) {
    object.unknown_from = object.known ? from : std::min(object.unknown_from, from);
    object.unknown_to = object.known ? to : std::max(object.unknown_to, to);
    object.known = false;
    object.unknown_because =
        tr("{} at {} writes to it, and a scene cannot use the result", command.name(), command.place.str());
}

// How many values of an array the command reads or writes; nullopt if that is not known.
std::optional<std::size_t> length_of(const Command& command, std::size_t i, std::optional<Enum> pname) {
    switch (command.sig().parameters[i].extent) {
        case Extent::kArrayByPname:
        case Extent::kOutput:
        case Extent::kOutputByPname: {
            const std::optional<int> by_table = array_length(command.id, pname);
            return by_table ? std::optional(static_cast<std::size_t>(*by_table)) : std::nullopt;
        }
        case Extent::kOutputByCount: return command.counted(i);
        default: return command.count(i);
    }
}

}  // namespace

// Reads an array of any type that the command writes to, or NULL. The argument's value is the size in bytes.
void Reader::written_argument(Command& command, const Parameter& parameter) {
    const Token start = token_;
    const Value given = expression();
    const bool is_null = !given.object && (given.is_pointer() || given.is_integer()) &&
                         (given.is_pointer() ? given.offset : given.integer) == 0;
    if (!given.object && !is_null) {
        fail(start.place,
             "the argument {} of {} must be an array for the result, or NULL; a scene cannot read back into buffer "
             "objects",
             parameter.name, command.name());
    }
    if (given.object)
        forget_values(*given.object, static_cast<std::size_t>(given.offset), given.object->bytes(), command);
    command.arguments.push_back(
        given.object ? static_cast<double>(given.object->bytes()) - static_cast<double>(given.offset) : 0.0);
}

void Reader::array_argument(Command& command, std::size_t i) {
    const Parameter& parameter = command.sig().parameters[i];
    const std::string_view name = command.name();
    const Token start = token_;
    if (start.is("{")) {
        const std::string_view type = c_type_name(c_type(parameter.kind));
        fail(start.place, "C does not allow {{...}} as an argument; write ({}[]){{...}}", type);
    }
    const Value given = expression();
    if (!given.object) {
        fail(start.place, "expected an array such as (GLfloat[]){{1, 0, 0, 1}} or the name of one, found {}",
             shown(start));
    }
    Object& object = *given.object;
    if (!object.memory) fail(start.place, "this memory was freed");
    if (given.of && given.of->is_pointer())
        fail(start.place, "{} takes an array of {}, but this is an array of pointers, or a pointer to one", name,
             c_type_name(c_type(parameter.kind)));
    const Kind kind = given.kind().value_or(parameter.kind);
    if (c_type(kind) != c_type(parameter.kind)) {
        fail(start.place, "{} takes an array of {}, but {} is an array of {}", name,
             c_type_name(c_type(parameter.kind)), object.shown, c_type_name(c_type(kind)));
    }
    const std::size_t size = size_of(kind);
    const auto offset = static_cast<std::size_t>(given.offset);
    const std::size_t available = (object.bytes() - offset) / size;

    const std::optional<Enum> pname =
        parameter.is_by_pname() ? std::optional(command.enumerant(command.arguments.size() - 1)) : std::nullopt;
    const std::size_t length = length_of(command, i, pname).value_or(available);
    const bool is_written = parameter.is_output() || parameter.extent == Extent::kNewNames;
    if (available < length) {
        if (is_written)
            fail(start.place, "{} writes {}, but {} has {}", with_pname(name, pname), values_text(length), object.shown,
                 available);
        fail(start.place, "{} reads {}, but {} has {}{}", with_pname(name, pname), values_text(length), object.shown,
             available, available == 3 ? fourth_value(command, pname) : "");
    }
    const bool is_get = command.id == CommandId::glGetIntegerv || command.id == CommandId::glGetFloatv ||
                        command.id == CommandId::glGetDoublev;
    if (is_get && pname == kGL_VIEWPORT && viewport_) {
        const std::span<std::byte> written = writable(object).bytes;
        for (std::size_t n = 0; n < length; ++n) store(written.subspan(offset + n * size), kind, (*viewport_)[n]);
        set_known(object, offset, length * size);
        return;
    }
    if (parameter.is_output()) return forget_values(object, offset, offset + length * size, command);
    constexpr std::size_t kShort = 16;  // the limit on the text covers shorter arrays
    if (length > kShort) hold(length * sizeof(double), start.place);
    if (parameter.extent == Extent::kNewNames) return give_names(command, *named_objects(parameter), given, length);
    check_known(object, offset, length * size, start.place);
    const std::span<const std::byte> bytes = object.memory->bytes;
    for (std::size_t n = 0; n < length; ++n) command.arguments.push_back(load(bytes.subspan(offset + n * size), kind));
}

void Reader::follow_viewport(const Command& command) {
    switch (command.id) {
        case CommandId::glViewport:
            viewport_ = {command.number(0), command.number(1), command.number(2), command.number(3)};
            break;
        case CommandId::glNewList:  // what a list changes is not followed
        case CommandId::glCallList:
        case CommandId::glCallLists:
        case CommandId::glPopAttrib: viewport_.reset(); break;
        default: break;
    }
}

// Records the names of `count` new objects and writes them to the array. A compound literal may give the names:
// (GLuint[]){7, 9}; 0 means that the reader chooses.
void Reader::give_names(Command& command, ObjectType type, const Value& array, std::size_t count) {
    const std::span<std::byte> bytes =
        std::span(writable(*array.object).bytes).subspan(static_cast<std::size_t>(array.offset));
    std::vector<double> names(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        if (array.object->is_literal) names[i] = load(bytes.subspan(i * sizeof(std::uint32_t)), Kind::kUint);
        names_.take(type, names[i], 1);
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (names[i] == 0) names[i] = names_.next(type, 1);
        names_.take(type, names[i], 1);
        store(bytes.subspan(i * sizeof(std::uint32_t)), Kind::kUint, names[i]);
    }
    set_known(*array.object, static_cast<std::size_t>(array.offset), bytes.size());
    command.arguments.insert(command.arguments.end(), names.begin(), names.end());
}

// The result of a command, if the reader can know it: the names of new lists, a framebuffer's status; otherwise 0.
double Reader::result(const Command& command, const Parameter& parameter) {
    if (returns_) {
        const double value = *returns_;
        returns_.reset();
        return value;
    }
    if (parameter.kind == Kind::kQuadric) return ++quadrics_;
    // A scene that draws into an incomplete one is refused.
    if (command.id == CommandId::glCheckFramebufferStatus) return kGL_FRAMEBUFFER_COMPLETE;
    const std::optional<ObjectType> type = named_objects(parameter);
    if (!type || command.number(0) < 1) return 0;
    return names_.next(*type, static_cast<std::uint32_t>(command.number(0)));
}

}  // namespace twinlight
