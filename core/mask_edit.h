// mask_edit.h -- operations on the whole painted mask.
#pragma once

#include <string>
#include <string_view>

#include "editor.h"
#include "region.h"
#include "script_text.h"

namespace pelage {

enum class MaskAct { invert, clear, fill, grow, shrink, smooth, length, density, region };

struct MaskEdit {
    MaskAct act = MaskAct::invert;
    int rings = 1;    // of grow, shrink, smooth; [1, kMostRings]
    Region region{};  // of region
};
inline constexpr int kMostRings = 1000;

// Invert: 1 - mask. Clear and fill: 0 and 1. Grow and shrink: the largest and least value over the
// vertex and its one-ring; smooth: their mean; each as often as there are rings. Length: the
// length of the hair in the world over that of the longest hair. Density: the density of the hair.
// Region: the weights of the region. Throws std::runtime_error as regionWeights does.
void applyMaskEdit(const SkinQuery& query, Groom& groom, const MaskEdit& change);

// How many one-rings reach about as far as a hundredth of the skin's size, at least 1: what grow,
// shrink and smooth take in the window, so that they do the same on a dense mesh.
int ringsOf(const Skin& skin);

// Lines of script: "mask invert", "mask clear", "mask fill", "mask grow 3", "mask shrink 3",
// "mask smooth 3" (1 unless said), "mask from length", "mask from density", "mask from WHERE ..."
// with a region as region_text.h writes it.
std::string maskLine(const MaskEdit& change);

// Runs what follows the first word of such a line, as one step of history. Throws
// std::runtime_error with what is wrong in the line; the document is then as before it.
void runMask(const SkinQuery& query, Editor& editor, Words& words);

}  // namespace pelage
