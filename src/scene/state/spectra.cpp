// The pragmas for spectra: the number of samples, the spectra of materials and lights, the conversion to sRGB.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "scene/shape/written_out.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

std::string names_of(std::span<const Spectrum> spectra) {
    std::vector<std::string_view> names;
    for (const Spectrum& spectrum : spectra) names.push_back(spectrum.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

void State::spectrum(const Command& c) {
    const double samples = c.number(0);
    if (samples == 0) {
        a_.lighting.light_model.spectrum = nullptr;
    } else if (samples >= SpectralSamples::kFewest && samples <= SpectralSamples::kMost) {
        a_.lighting.light_model.spectrum = std::make_shared<const SpectralSamples>(static_cast<int>(samples));
    } else {
        raise(kGL_INVALID_VALUE, c,
              "spectrum({}): the number of samples must be 0 (red, green and blue) or from {} to {}", samples,
              SpectralSamples::kFewest, SpectralSamples::kMost);
    }
}

void State::reflectance(const Command& c) {
    if (!known(c, c.enumerant(1), {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR, kGL_AMBIENT_AND_DIFFUSE})) return;
    if (const std::optional<Command> color = gl_command_of(c))
        return set_material(*color, find_reflectance(word_name(c.word(2))));
    raise(kGL_INVALID_ENUM, c, "{} is not a reflectance; expected {}", word_name(c.word(2)), names_of(reflectances()));
}

void State::illuminant(const Command& c) {
    if (!known(c, c.enumerant(1), {kGL_DIFFUSE, kGL_SPECULAR})) return;
    LightSource* source = light_source(c, c.enumerant(0));
    if (!source) return;
    const Spectrum* light = find_illuminant(word_name(c.word(2)));
    const double scale = c.number(3);
    if (!light)
        return raise(kGL_INVALID_ENUM, c, "{} is not the spectrum of a light; expected {}", word_name(c.word(2)),
                     names_of(illuminants()));
    if (!(scale >= 0 && std::isfinite(scale)))
        return raise(kGL_INVALID_VALUE, c, "the light's scale is {}; it must be 0 or more", scale);
    const std::optional<Command> color = gl_command_of(c);
    const Enum pname = c.enumerant(1);
    set_light(c, *source, pname, std::vector<double>(color->arguments.begin() + 2, color->arguments.end()));
    (pname == kGL_DIFFUSE ? source->diffuse_illuminant : source->specular_illuminant) = {light, scale};
}

void State::transfer(const Command& c) {
    if (c.word(0) == Word::linear || c.word(0) == Word::srgb)
        a_.fragment.srgb_coded = c.word(0) == Word::srgb;
    else
        raise(kGL_INVALID_ENUM, c, "transfer({}) is unknown; expected linear or srgb", word_name(c.word(0)));
}

}  // namespace twinlight
