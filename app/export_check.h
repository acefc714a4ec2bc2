// export_check.h -- proves a written file by opening it again.
#pragma once

#include <string>

#include "core/document.h"

namespace pelage {

// Reads `path` and compares it with what was written, bit for bit. Returns what to append to
// "Exported FILE"; throws std::runtime_error naming the first difference.
std::string checkExport(const Document& document, const std::string& path, Progress* progress);

}  // namespace pelage
