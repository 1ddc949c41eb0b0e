// The probe: the terms and the vectors of the lighting at a pixel, as the window shows them (app/session/probe.h).
#pragma once

#include <string>

#include "render/look.h"
#include "scene/frame/scene.h"

namespace twinlight::web {

// JSON, for a pixel counted from the upper left corner:
//   {"heading": "The equation at vertex 12 of draw 3", "rows": [{"sign", "what", "how", "color": [r, g, b], "is_result"}],
//    "mean": rows of the mean of the vertices, or [], "arrows": [{"kind", "name", "from": [x, y], "to": [x, y]}]}
// The fragment is the one that is seen, the vertex the one with the largest share. Without lighting there, the lists are empty.
std::string probed(const Scene& scene, const Look& look, int x, int y);

}  // namespace twinlight::web
