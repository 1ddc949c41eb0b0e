// Numbers as `apitrace dump` prints them, so that a .trace and its dump give the same picture.
#pragma once

namespace twinlight::trace {

double as_printed(float value);   // with 7 digits, as by "%.7g"
double as_printed(double value);  // with 16

}  // namespace twinlight::trace
