#include "app/study_renderers.h"

#include <algorithm>
#include <stdexcept>

#include "judge/study/scene_of_choice.h"
#include "render/context/gl.h"
#include "render/fixed/replay.h"
#include "render/reference/reference.h"

namespace twinlight {

namespace {

// Averages each square of samples.
Image reduced(const Image& image, int samples) {
    Image result(image.width / samples, image.height / samples);
    const auto count = static_cast<float>(samples * samples);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 4; ++c) result.at(x / samples, y / samples)[c] += image.at(x, y)[c] / count;
    return result;
}

// Pictures in floats may have values outside [0, 1].
Image clamped(Image image) {
    for (Rgba& pixel : image.pixels)
        for (float& channel : pixel) channel = std::clamp(channel, 0.0F, 1.0F);
    return image;
}

study::Prepared by_reference(Frame frame, const study::Choice& choice) {
    const auto ready = std::make_shared<const Frame>(std::move(frame));
    const auto picture = [ready, options = choice.reference_options(), samples = choice.samples] {
        Image image = reference::render(*ready, options);
        return samples == 1 ? image : reduced(image, samples);
    };
    return {[picture] { picture(); }, picture};
}

// The precise program needs GLSL 4.00 and allows no more lights than the fixed function.
std::shared_ptr<programmable::UploadedFrame> prepared_for_shaders(const Frame& frame, const study::Choice& choice) {
    try {
        return std::make_shared<programmable::UploadedFrame>(frame, choice.shader_options());
    } catch (const std::runtime_error& refusal) {
        if (choice.method == study::Method::kPrecise) throw study::Refused(refusal.what());
        throw;
    }
}

}  // namespace

StudyRenderers::StudyRenderers(int width, int height)
    : width_(width),
      height_(height),
      context_(make_offscreen_context(width, height)),
      shaders_({.programs = 1024}) {}  // enough to keep all programs of a study

study::ChoiceRenderers StudyRenderers::functions() {
    return {[this](const Frame& frame, const study::Choice& choice) { return prepare(frame, choice); },
            reference::seen_shapes};
}

const RenderTarget& StudyRenderers::target_of(const study::Choice& choice) {
    const ColorBuffer kind = choice.target == study::Target::kFloats ? ColorBuffer::kFloat : ColorBuffer::kUnorm8;
    return targets_.try_emplace({choice.target, choice.samples}, width_, height_, kind, choice.samples).first->second;
}

study::Prepared StudyRenderers::prepare(const Frame& frame, const study::Choice& choice) {
    if (frame.copies_pixels) target_of(choice).bind();  // pixels are copied from it
    Frame drawn = choice.samples == 1 ? frame : study::enlarged(frame, choice.samples);
    if (choice.method == study::Method::kReference) return by_reference(std::move(drawn), choice);
    std::function<void()> draw;
    if (choice.method == study::Method::kFixed) {
        const auto kept = std::make_shared<const Frame>(std::move(drawn));
        const auto ready = std::make_shared<fixed::Replay>(*kept, choice.fixed_options());
        draw = [kept, ready] { ready->draw(); };
    } else {
        const auto ready = prepared_for_shaders(drawn, choice);
        draw = [this, ready] { shaders_.draw(*ready); };
    }
    const RenderTarget& target = target_of(choice);
    const auto finish = [draw, &target] {
        target.bind();
        draw();
        target.resolve();
        glFinish();
    };
    return {finish, [finish, &target] {
                finish();
                return clamped(target.read());
            }};
}

}  // namespace twinlight
