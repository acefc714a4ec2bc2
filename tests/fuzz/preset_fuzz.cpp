// preset_fuzz.cpp -- any bytes are a preset that survives a round trip, or an error of one line.
#include "core/preset_file.h"
#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace pelage;
    fuzz::doneOrRefused([&] {
        const std::string_view text(reinterpret_cast<const char*>(data), size);
        const Preset preset = presetFromText(text, "fuzz.fur.json");
        const Preset again = presetFromText(presetText(preset), "fuzz.fur.json");
        fuzz::check(again.fur == preset.fur && again.name == preset.name &&
                    again.thumbnail == preset.thumbnail && again.seeded == preset.seeded);
    });
    return 0;
}
