// The text of a dump, seen through a buffer of fixed size: however long the text is, and however long one call of it.
//
// Tokens (numbers, names) are short, so a whole one always lies in the buffer; strings are passed over as they come.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace twinlight::trace {

// Bytes from somewhere, read once from the front to the back.
class ByteSource {
  public:
    virtual ~ByteSource() = default;
    // Puts the next bytes at `to`: `size` of them at most, one at least; none at the end. Throws SceneError where they
    // cannot be read.
    virtual std::size_t read(char* to, std::size_t size) = 0;
};

class DumpLexer {
  public:
    static constexpr std::size_t kLongestToken = 1024;

    explicit DumpLexer(ByteSource& source) : source_(source), buffer_(kBufferSize + 1) {
        position_ = end_ = &buffer_[0];
    }

    // The next character; 0 at the end of the text.
    char peek() {
        if (position_ == end_) refill();
        return *position_;
    }
    bool at_end() { return peek() == '\0' && position_ == end_; }
    void skip() { ++position_; }  // what peek showed
    bool accept(char c) {
        if (peek() != c) return false;
        skip();
        return true;
    }
    bool accept(std::string_view word);  // all of it, or nothing of it
    void skip_blanks() {
        while (peek() == ' ') skip();
    }

    // Letters, digits and underscores from here on, kLongestToken at most. Valid until the second token after it.
    std::string_view word() {
        if (static_cast<std::size_t>(end_ - position_) < 2 * kLongestToken + 1) refill();
        const char* const start = position_;
        const char* const longest = start + kLongestToken;
        while (position_ < longest && is_word(*position_)) ++position_;
        return {start, position_};
    }
    // A number from here on, decimal or hexadecimal, with its sign; a word such as inf is not one. False where none is.
    bool number(double& value);

    // To the end of the line that ends this call, which is passed over too: a line's end inside a string does not end
    // it. Whether a line's end was there, before that of the text.
    bool skip_line();
    // The string from its opening quotation mark on: at most `longest` of its characters, as they stand.
    std::string_view string(std::size_t longest);

    int line() const { return line_; }  // counts from 1
    void count_line() { ++line_; }      // where a line's end was passed over by other means

  private:
    static constexpr std::size_t kBufferSize = 1 << 16;

    static bool is_word(char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    }
    void prepare_token() {
        if (static_cast<std::size_t>(end_ - position_) < kLongestToken) refill();
    }
    void refill();
    void skip_string();

    ByteSource& source_;
    bool source_ended_ = false;
    std::vector<char> buffer_;
    const char* position_;  // in buffer_
    char* end_;             // of what is in buffer_; a 0 stands there
    int line_ = 1;
    std::string string_;
};

}  // namespace twinlight::trace
