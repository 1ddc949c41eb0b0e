// Accuracy: which shading and mesh an error needs in this scene, and how fast they are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/study/study.h"
#include "scene/frame/frame.h"

namespace twinlight::session {

// What is measured: shaders that light vertices (Gouraud) and pixels (Phong) on coarse and fine meshes, and exact surfaces.
// Without shapes that have slices only the scene's own mesh.
std::vector<study::Choice> accuracy_choices(const Frame& frame, bool has_slices);

// One measured way to draw.
struct AccuracyRow {
    std::string shading;  // "Gouraud"
    int slices = 0;       // 0: the scene's own mesh, or an exact surface
    double error = 0;     // rms of all pixels, from 0 to 1
    double ms = 0;
    bool is_enough = false;  // the error is at most the target
};
std::vector<AccuracyRow> accuracy_rows(const study::Study& study, double target);

// "For an error of at most 1/255: Gouraud needs 48 slices (2.10 ms). Phong needs 24 slices (1.20 ms). Exact surfaces take
// 0.90 ms, which is faster than both." Empty without rows.
std::string accuracy_sentence(const std::vector<AccuracyRow>& rows, double target);

}  // namespace twinlight::session
