// The text of a dump, from its front any number of times: a file; or what comes through a pipe, which is kept in a file
// as it comes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "base/image/descriptor.h"
#include "scene/trace/dump_lexer.h"

namespace twinlight::trace {

class DumpText {
  public:
    // A file that can be read anywhere. `name` is for messages.
    DumpText(std::string name, Descriptor file) : name_(std::move(name)), file_(std::move(file)) {}
    // What comes through `pipe`, kept in `file`, which is empty. `ended` is called once, where the pipe's end is met.
    DumpText(std::string name, Descriptor file, Descriptor pipe, std::function<void()> ended)
        : name_(std::move(name)), file_(std::move(file)), pipe_(std::move(pipe)), ended_(std::move(ended)) {}

    // What of the pipe has been read from it already: to be called first.
    void put_in_front(std::string_view bytes) { keep(bytes); }

    // The bytes from `offset` on; as ByteSource::read. Reads from the pipe where the file does not reach.
    std::size_t read_at(std::uint64_t offset, char* to, std::size_t size);

  private:
    void keep(std::string_view bytes);
    [[noreturn]] void refuse(int error) const;

    std::string name_;
    Descriptor file_, pipe_;
    std::uint64_t kept_ = 0;  // of the pipe, in the file
    std::function<void()> ended_;
};

// One reading of it.
class DumpTextReading final : public ByteSource {
  public:
    explicit DumpTextReading(DumpText& text) : text_(text) {}
    std::size_t read(char* to, std::size_t size) override {
        const std::size_t count = text_.read_at(offset_, to, size);
        offset_ += count;
        return count;
    }

  private:
    DumpText& text_;
    std::uint64_t offset_ = 0;
};

}  // namespace twinlight::trace
