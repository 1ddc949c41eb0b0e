// The text of a dump, which can be read any number of times: a file, or the output of a pipe, which is stored in a
// temporary file while it is read.
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
    // The text of a file that allows random access. `name` appears in messages.
    DumpText(std::string name, Descriptor file) : name_(std::move(name)), file_(std::move(file)) {}
    // The text from `pipe`, stored in the empty `file`. `ended` is called once, at the end of the pipe.
    DumpText(std::string name, Descriptor file, Descriptor pipe, std::function<void()> ended)
        : name_(std::move(name)), file_(std::move(file)), pipe_(std::move(pipe)), ended_(std::move(ended)) {}

    // Adds the bytes that were already read from the pipe. Call it first.
    void put_in_front(std::string_view bytes) { keep(bytes); }

    // Reads the bytes from `offset` on, like ByteSource::read. Bytes that are not yet stored come from the pipe.
    std::size_t read_at(std::uint64_t offset, char* to, std::size_t size);

  private:
    void keep(std::string_view bytes);
    [[noreturn]] void refuse(int error) const;

    std::string name_;
    Descriptor file_, pipe_;
    std::uint64_t kept_ = 0;  // the number of bytes stored in the file
    std::function<void()> ended_;
};

// Reads a DumpText from start to end.
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
