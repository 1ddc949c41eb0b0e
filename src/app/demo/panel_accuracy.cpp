#include "app/demo/panel_accuracy.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "app/study_renderers.h"
#include "base/text/reason.h"
#include "base/text/translation.h"
#include "base/threads/threads.h"
#include "judge/study/scene_of_choice.h"
#include "scene/state/state.h"

namespace twinlight::demo {
namespace {

constexpr WindowSize kSize{320, 240};
constexpr double kSeconds = 3;  // for timing

struct Target {
    double error;
    const char* words;
};
constexpr std::array<Target, 6> kTargets = {{{0.5 / 255, "0.5/255"},
                                             {1.0 / 255, "1/255"},
                                             {2.0 / 255, "2/255"},
                                             {4.0 / 255, "4/255"},
                                             {8.0 / 255, "8/255"},
                                             {16.0 / 255, "16/255"}}};

}  // namespace

// A study in a thread of its own, with a connection and a context of its own.
struct AccuracyPanel::Measurement {
    Measurement(std::shared_ptr<const CommandList> list, int list_revision)
        : revision(list_revision), commands(std::move(list)), thread(try_start_thread([this] { run(); })) {
        if (thread.joinable()) return;
        trouble = tr("the system gives no thread for this; close other programs and try again");
        is_finished = true;
    }
    ~Measurement() {
        is_stopped = true;
        if (thread.joinable()) thread.join();
    }

    void run() {
        try {
            // The scene's own proportions are those of its commands, so a smaller picture only has fewer pixels.
            const CommandList small = session::scaled(*commands, session::natural_size(*commands), kSize);
            const StateOptions size{.width = kSize.width, .height = kSize.height};
            const bool has_slices = study::has_slices(small);
            const auto frame_of = [&](int slices) {
                return slices == 0 ? make_frame(small, size) : make_frame(study::with_slices(small, slices), size);
            };
            StudyRenderers renderers(kSize.width, kSize.height);
            study::Settings settings;
            settings.seconds = kSeconds;
            settings.choices = session::accuracy_choices(frame_of(0), has_slices);
            settings.progress = [this](const study::Progress& progress) {
                const std::lock_guard lock(mutex);
                share =
                    progress.total == 0 ? 0.0F : static_cast<float>(progress.done) / static_cast<float>(progress.total);
                step = progress.next;
                return !is_stopped;
            };
            study::Study result = study::run(frame_of, has_slices, renderers.functions(), settings);
            const std::lock_guard lock(mutex);
            study = std::move(result);
        } catch (const std::exception& error) {
            const std::lock_guard lock(mutex);
            trouble = reason_of(error);
        }
        is_finished = true;
    }

    const int revision;
    const std::shared_ptr<const CommandList> commands;
    std::atomic<bool> is_stopped = false, is_finished = false;
    std::mutex mutex;  // for the four below
    float share = 0;
    std::string step, trouble;
    study::Study study;
    std::thread thread;  // the last member: it uses the others
};

AccuracyPanel::AccuracyPanel() : target_(1) {}
AccuracyPanel::~AccuracyPanel() = default;

bool AccuracyPanel::is_busy() const { return measurement_ != nullptr; }

void AccuracyPanel::start(const session::Session& session) {
    trouble_.clear();
    measurement_ = std::make_unique<Measurement>(session.history.now(), session.history.revision());
}

void AccuracyPanel::show_rows(double target) const {
    const std::vector<session::AccuracyRow> rows = session::accuracy_rows(study_, target);
    if (!ImGui::BeginTable("rows", 4, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) return;
    ImGui::TableNextRow();
    for (const char* head : {"shading", "slices", "error", "time"}) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", tr(head));
    }
    for (const session::AccuracyRow& row : rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, row.is_enough ? kGood : kDim);
        ImGui::TextUnformatted(tr(row.shading).c_str());
        ImGui::PushFont(fonts().code);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.slices > 0 ? fmt::format("{:4}", row.slices).c_str() : "   -");
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(fmt::format("{:5.2f}/255", 255 * row.error).c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(fmt::format("{:6.2f} ms", row.ms).c_str());
        ImGui::PopFont();
        ImGui::PopStyleColor();
    }
    ImGui::EndTable();
}

void AccuracyPanel::show(session::Session& session) {
    dim_text(
        tr("How fine must the mesh be? This draws the scene with coarse and fine meshes, lit at the vertices (Gouraud) "
           "and at every pixel (Phong), and with exact surfaces. It measures the time and the error of each: the "
           "difference from the exact picture, as rms over all pixels."));
    if (measurement_ && measurement_->is_finished) {
        measured_ = measurement_->revision;
        const std::lock_guard lock(measurement_->mutex);
        study_ = std::move(measurement_->study);
        trouble_ = measurement_->trouble;
    }
    if (measurement_ && measurement_->is_finished) measurement_.reset();
    if (measurement_) {
        float share = 0;
        std::string step;
        {
            const std::lock_guard lock(measurement_->mutex);
            share = measurement_->share;
            step = measurement_->step;
        }
        ImGui::ProgressBar(share, {-1, 0}, step.c_str());
        if (ImGui::Button(tr(measurement_->is_stopped ? "Stopping ..." : "Stop"))) measurement_->is_stopped = true;
        return;
    }
    if (ImGui::Button(tr(study_.points.empty() ? "Measure" : "Measure again"))) start(session);
    if (!trouble_.empty()) colored_text(kBad, trouble_);
    if (study_.points.empty()) return;
    if (measured_ != session.history.revision()) colored_text(kAccent, tr("The scene has changed since."));

    heading(tr("The error that you accept"));
    ImGui::SetNextItemWidth(8 * ImGui::GetFontSize());
    if (ImGui::BeginCombo(tr("of a channel"), kTargets[static_cast<std::size_t>(target_)].words)) {
        for (std::size_t i = 0; i < kTargets.size(); ++i)
            if (ImGui::Selectable(kTargets[i].words, static_cast<int>(i) == target_)) target_ = static_cast<int>(i);
        ImGui::EndCombo();
    }
    const double target = kTargets[static_cast<std::size_t>(target_)].error;
    const std::string sentence = session::accuracy_sentence(session::accuracy_rows(study_, target), target);
    ImGui::Dummy({0, 2});
    bold_text(sentence.empty() ? tr("Nothing was timed; measure again.") : sentence);
    ImGui::Dummy({0, 2});
    show_rows(target);
    dim_text(tr("{} x {} pixels, shaders with uniforms, on this machine. For the rest: twinlight study.", study_.width,
                study_.height));
}

}  // namespace twinlight::demo
