// accuracy_report.h -- what was measured in the window, as files.
#pragma once

#include <string>

#include "app/accuracy.h"

namespace pelage {

// Writes the figures to `path`, a .csv with one line for each distance and the view itself first;
// beside it NAME-live.png, NAME-reference.png and NAME-heat.png. Throws std::runtime_error.
void writeAccuracyReport(const std::string& path, const Accuracy& accuracy,
                         const std::string& device);

}  // namespace pelage
