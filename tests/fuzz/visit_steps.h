// Reads a recording as programs do: first its contexts, then the steps of the busiest one.
#pragma once

#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>

#include "scene/command/text.h"
#include "scene/trace/call_reader.h"
#include "scene/trace/contexts.h"

namespace twinlight {

// Aborts if an error has two lines. `start` reads the calls from the first on.
inline void visit_steps(const std::function<std::unique_ptr<trace::CallSource>()>& start,
                        const trace::BlobLoader& blobs, bool whole) {
    trace::ContextCounts counts;
    try {
        const auto calls = start();
        trace::CallReader reader(*calls, "fuzz", blobs);
        reader.count_contexts(whole, counts);
        reader.at_end();
    } catch (const SceneError&) {  // reading throws it again
    }
    list_of_contexts(counts.contexts());
    const std::optional<std::size_t> busiest = counts.busiest();
    try {
        const auto calls = start();
        trace::CallReader reader(*calls, "fuzz", blobs);
        if (busiest) {
            const trace::ContextUse& use = counts.contexts()[*busiest];
            reader.follow(use.name, use.shown_objects());
        }
        reader.for_each([](const Step& step) {
            if (step.kind == Step::Kind::kCommand) print_command(step.command);
            return true;
        });
    } catch (const SceneError& error) {
        if (std::strchr(error.what(), '\n')) std::abort();
    }
}

}  // namespace twinlight
