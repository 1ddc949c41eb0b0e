// The panel "Accuracy": measures on request which shading and mesh an error needs in this scene.
#pragma once

#include <memory>
#include <string>

#include "app/session/accuracy.h"
#include "app/session/session.h"

namespace twinlight::demo {

class AccuracyPanel {
  public:
    AccuracyPanel();
    ~AccuracyPanel();  // stops the measurement, and waits for the picture that is being drawn
    AccuracyPanel(const AccuracyPanel&) = delete;
    AccuracyPanel& operator=(const AccuracyPanel&) = delete;

    void show(session::Session& session);
    bool is_busy() const;

  private:
    struct Measurement;

    void start(const session::Session& session);
    void show_rows(double target) const;

    std::unique_ptr<Measurement> measurement_;
    study::Study study_;
    int measured_ = -1;  // the history's revision that was measured
    std::string trouble_;
    int target_ = 0;  // index of the error that the user wants
};

}  // namespace twinlight::demo
