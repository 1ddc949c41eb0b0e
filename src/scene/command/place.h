// Place: where a command stands in its text. Apart from command.h, so that what only names places does not depend on commands.
#pragma once

#include <memory>
#include <string>

namespace twinlight {

// The place of a command in its text. Lines and columns count from 1; 0 means unknown. A recorded program has a place in its
// own source where the recording has its call stacks; otherwise `line` is the number of the call and `column` is kCallNumber.
struct Place {
    static constexpr int kCallNumber = -1;

    std::shared_ptr<const std::string> file;
    int line = 0;
    int column = 0;
    std::shared_ptr<const std::string> calls{};  // of a recorded program: "main > display > draw_lamp"; null if unknown

    std::string str() const;  // "scene.gl:14:22", "program.trace: call 1234"

    // Whether both are the same place: a recording that is read again has names of its own.
    friend bool operator==(const Place& a, const Place& b) {
        const bool same_file = a.file == b.file || (a.file && b.file && *a.file == *b.file);
        return a.line == b.line && a.column == b.column && same_file;
    }
};

}  // namespace twinlight
