// The machine that the program runs on.
#pragma once

#include "judge/study/study.h"

namespace twinlight::cli {

study::Machine this_machine();

}  // namespace twinlight::cli
