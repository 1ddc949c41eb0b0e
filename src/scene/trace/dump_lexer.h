// Splits the text of a dump into tokens. Its buffer has a fixed size, even if the text or a single call is very long.
//
// Tokens (numbers, names) are short, so the buffer always contains a whole one. Long strings are skipped piece by
// piece.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace twinlight::trace {

// A source of bytes, read once from start to end.
class ByteSource {
  public:
    virtual ~ByteSource() = default;
    // Writes the next bytes to `to` and returns their number: 1 to `size`, or 0 at the end. Throws SceneError if
    // reading fails.
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
    void skip() { ++position_; }  // skips the character that peek() returned
    bool accept(char c) {
        if (peek() != c) return false;
        skip();
        return true;
    }
    bool accept(std::string_view word);  // skips the whole word, or nothing
    void skip_blanks() {
        while (peek() == ' ') skip();
    }

    // Reads letters, digits and underscores, at most kLongestToken. The result stays valid until the second token after
    // it.
    std::string_view word() {
        if (static_cast<std::size_t>(end_ - position_) < 2 * kLongestToken + 1) refill();
        const char* const start = position_;
        const char* const longest = start + kLongestToken;
        while (position_ < longest && is_word(*position_)) ++position_;
        return {start, static_cast<std::size_t>(position_ - start)};
    }
    // Reads a decimal or hexadecimal number with its sign, but no word such as inf. Returns false if there is none.
    bool number(double& value);

    // Skips the rest of the line including its end. A line end inside a string does not count. Returns false if the
    // text ended before the line.
    bool skip_line();
    // Adds the rest of the line to `to`, without its end, and skips that. `to` grows to at most `longest` bytes.
    void rest_of_line(std::string& to, std::size_t longest);
    // Reads a string from its opening quotation mark on. Returns its first `longest` characters, without decoding
    // escapes.
    std::string_view string(std::size_t longest);

    int line() const { return line_; }  // counts from 1
    void count_line() { ++line_; }      // call it after skipping a line end with accept()

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
    char* end_;             // the end of the bytes in buffer_, where a 0 is stored
    int line_ = 1;
    std::string string_;
};

}  // namespace twinlight::trace
