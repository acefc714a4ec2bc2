// reference.h -- pelage render --technique reference.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/cli/print.h"
#include "app/render/renderer.h"

namespace pelage {

inline constexpr const char* kReferenceTechnique = "reference";

struct TraceOptions {
    uint samples = 64;  // of each pixel
    std::string shadows = "traced";
    uint segments = 0;  // of each hair; 0 = as many as its shape needs
    uint seed = 1;
};

// --spp, --shadows, --segments and --seed.
void addTraceOptions(CLI::App& verb, TraceOptions& options);

// Traces the picture of a view, writes it and prints what there is to tell.
void traceReference(const Document& document, const View& view, const TraceOptions& options,
                    const std::string& output, bool json);

}  // namespace pelage
