#include "judge/study/scene_of_choice.h"

#include <algorithm>

namespace twinlight::study {

SliceArguments slice_arguments(const Command& command) {
    switch (command.id) {
        case CommandId::glutSolidSphere:
        case CommandId::glutWireSphere: return {1, 2};
        case CommandId::glutSolidCone:
        case CommandId::glutWireCone:
        case CommandId::glutSolidCylinder:
        case CommandId::glutWireCylinder: return {2, 3};
        case CommandId::glutSolidTorus:
        case CommandId::glutWireTorus: return {3, 2};
        case CommandId::gluSphere: return {2, 3};
        case CommandId::gluCylinder: return {4, 5};
        case CommandId::gluDisk:
        case CommandId::gluPartialDisk: return {3, 4};
        case CommandId::pragma_shape: break;
        default: return {};
    }
    switch (command.word(0)) {
        case Word::sphere: return {2, 3};
        case Word::cylinder:
        case Word::cylinder_triangles:
        case Word::cone: return {3, 0};
        default: return {};
    }
}

CommandList with_slices(const CommandList& scene, int slices) {
    constexpr int kLeast = 3;
    CommandList result = scene;
    for (Command& command : result.commands) {
        const auto [around, across] = slice_arguments(command);
        if (around != 0) command.arguments.at(around) = std::max(slices, kLeast);
        if (across != 0) command.arguments.at(across) = std::max(slices / 2, kLeast);
    }
    return result;
}

bool has_slices(const CommandList& scene) {
    return std::ranges::any_of(scene.commands,
                               [](const Command& command) { return slice_arguments(command).around != 0; });
}

Frame enlarged(const Frame& frame, int samples) {
    Frame result = frame;
    result.width *= samples;
    result.height *= samples;
    const auto enlarge = [&](Rectangle& box) {
        for (int* length : {&box.x, &box.y, &box.width, &box.height}) *length *= samples;
    };
    for (auto& item : result.items) {
        if (Clear* clear = std::get_if<Clear>(&item)) enlarge(clear->scissor.box);
        if (Accumulate* accumulate = std::get_if<Accumulate>(&item)) enlarge(accumulate->scissor.box);
        if (TakePixels* copy = std::get_if<TakePixels>(&item)) enlarge(copy->from);
    }
    for (Draw* draw : result.editable_draws()) {
        enlarge(draw->raster.viewport);
        draw->change_source(enlarge);
        enlarge(draw->fragment.scissor.box);
        draw->raster.line_width *= samples;
        if (draw->raster.line_stipple) draw->raster.line_stipple->factor *= samples;
        draw->raster.point_size *= samples;
        draw->raster.polygon_offset.factor *= samples;  // the slope of the depth is per pixel (3.5.5)
    }
    return result;
}

}  // namespace twinlight::study
