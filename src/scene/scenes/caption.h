// Caption: what a scene shows and what to notice, from its first comment.
#pragma once

#include <string>
#include <string_view>

#include "scene/command/command.h"

namespace twinlight {

struct Caption {
    std::string title{};   // the first sentence; empty without a comment
    std::string notice{};  // the sentence that begins with "Notice", and the next; without it, the two after the title
    std::string all{};     // the whole comment, its paragraphs separated by empty lines
};
Caption caption_of(std::string_view text);
Caption caption_of(const CommandList& scene);

}  // namespace twinlight
