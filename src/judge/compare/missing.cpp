#include "judge/compare/missing.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace twinlight::compare {

namespace {

// Commands of one kind: "glEnable(GL_FOG)", "glTexParameter(GL_TEXTURE_LOD_BIAS)" with any type, "glEvalMesh2".
struct NamedCommands {
    std::string function;      // without its type
    std::vector<Enum> values;  // each of them is an argument
};

// The names in "(GL_FOG_COORD_SRC, GL_FOG_COORD)"; nullopt if one is unknown.
std::optional<std::vector<Enum>> values_in(std::string_view list) {
    std::vector<Enum> values;
    while (!list.empty()) {
        const std::size_t end = std::min(list.find_first_of(",)"), list.size());
        const std::optional<Enum> value = find_gl_name_or_extension(list.substr(0, end));
        if (!value) return std::nullopt;
        values.push_back(*value);
        list.remove_prefix(std::min(end + 1, list.size()));
        while (list.starts_with(' ')) list.remove_prefix(1);
    }
    return values;
}

std::optional<NamedCommands> kind_of(std::string_view name) {
    const std::size_t bracket = std::min(name.find('('), name.size());
    const std::string_view function = name.substr(0, bracket);
    // The other renderers do not ignore these: a copied image is black there, and so is a texel of GL_COMBINE that comes
    // from a unit without a texture.
    if (function.starts_with("glCopyTexImage") || function.starts_with("glTexEnv")) return std::nullopt;
    const bool is_command = function.starts_with("gl") && function.find(' ') == std::string_view::npos;
    const bool is_closed = bracket == name.size() || name.ends_with(')');
    if (!is_command || !is_closed) return std::nullopt;
    auto values = values_in(name.substr(std::min(bracket + 1, name.size())));
    if (!values) return std::nullopt;
    return NamedCommands{std::string(function), std::move(*values)};
}

// Whether `name` is `function`, perhaps with a type: glTexParameter, glTexParameterfv.
bool is_named(std::string_view name, std::string_view function) {
    if (!name.starts_with(function)) return false;
    return name.substr(function.size()).find_first_not_of("1234bsifdubv") == std::string_view::npos;
}

class Without final : public Recording {
  public:
    Without(std::shared_ptr<const Recording> whole, std::vector<NamedCommands> kinds)
        : Recording(whole->name), whole_(std::move(whole)), kinds_(std::move(kinds)) {}

    void for_each(const std::function<bool(const Step&)>& visit) const override {
        whole_->for_each([&](const Step& step) {
            if (step.kind != Step::Kind::kCommand) return visit(step);
            return is_left_out(step.command) || visit(step);
        });
    }

  private:
    bool is_left_out(const Command& command) const {
        const auto has = [&](Enum value) {
            return std::ranges::find(command.arguments, static_cast<double>(value)) != command.arguments.end();
        };
        return std::ranges::any_of(kinds_, [&](const NamedCommands& kind) {
            return is_named(command.name(), kind.function) && std::ranges::all_of(kind.values, has);
        });
    }

    std::shared_ptr<const Recording> whole_;
    std::vector<NamedCommands> kinds_;
};

}  // namespace

std::shared_ptr<const Recording> without_missing(std::shared_ptr<const Recording> recording,
                                                 const std::vector<Unsupported>& missing) {
    std::vector<NamedCommands> kinds;
    for (const Unsupported& item : missing) {
        if (item.missing_from != MissingFrom::kFrame) continue;
        std::optional<NamedCommands> kind = kind_of(item.name);
        if (!kind) return nullptr;
        kinds.push_back(std::move(*kind));
    }
    if (kinds.empty()) return nullptr;
    return std::make_shared<const Without>(std::move(recording), std::move(kinds));
}

Scene with_commands(const Scene& scene, std::shared_ptr<const Recording> recording) {
    Scene result{std::move(recording), {}};
    result.frame.width = scene.frame.width;
    result.frame.height = scene.frame.height;
    result.frame.lists_called_before_made = scene.frame.lists_called_before_made;
    return result;
}

PixelMask changed_pixels(const Image& with, const Image& without) {
    PixelMask changed(with.pixels.size());
    for (std::size_t i = 0; i < with.pixels.size(); ++i)
        for (int channel = 0; channel < 4; ++channel)
            changed[i] =
                changed[i] || channel_code(with.pixels[i][channel]) != channel_code(without.pixels[i][channel]);
    return changed;
}

}  // namespace twinlight::compare
