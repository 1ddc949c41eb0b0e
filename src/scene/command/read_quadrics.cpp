// Reads GLU's quadrics: variables that point to them, and gluNewQuadric(). Quadrics are numbered from 1 in order of
// creation.
#include <fmt/format.h>

#include "scene/command/memory.h"
#include "scene/command/reader.h"

namespace twinlight {

// The rest of the assignment q = gluNewQuadric(); after the name.
void Reader::quadric_assignment(Object& object) {
    expect("=", "after {}", object.shown);
    fill(object, quadric_value());
    expect(";", "after the assignment");
}

// Reads gluNewQuadric(), the name of a quadric, or NULL or 0 for none.
double Reader::quadric_value() {
    const Token token = token_;
    if (program_) return in_kind(expression(), Kind::kQuadric, token.place).number();
    if (token.is("gluNewQuadric")) return call().arguments.back();
    advance();
    if (token.is("NULL") || (token.kind == TokenKind::kNumber && token.text == "0")) return 0;
    const Object* const found = token.kind == TokenKind::kName ? find_variable(token.text) : nullptr;
    if (!found || found->type->kind != Kind::kQuadric) {
        const auto near = nearest(token.text, visible_names());
        fail(token.place, "expected gluNewQuadric() or the name of a GLUquadric*, found {}{}", shown(token),
             found ? "" : did_you_mean(near));
    }
    const Object& object = *found;
    if (!object.known) {
        fail(token.place, "{} has no value here: {}; write {} = gluNewQuadric();", object.shown, object.unknown_because,
             token.text);
    }
    return load(object.memory->bytes, Kind::kQuadric);
}

double Reader::quadric_argument(const Command& command) {
    const Place place = token_.place;
    const double quadric = quadric_value();
    if (quadric == 0) fail(place, "{} needs a quadric; create one with gluNewQuadric()", command.name());
    return quadric;
}

}  // namespace twinlight
