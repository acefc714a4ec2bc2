// mask_edit.cpp -- what each operation makes of the mask, and its line of script.
#include "mask_edit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "region_text.h"
#include "text.h"

namespace pelage {
namespace {

constexpr float kReach = 0.01f;  // of the skin's size, of growing and the like in the window

constexpr std::array<const char*, 8> kActs{"invert", "clear",  "fill",   "grow",
                                           "shrink", "smooth", "length", "density"};

bool byRings(MaskAct act) {
    return act == MaskAct::grow || act == MaskAct::shrink || act == MaskAct::smooth;
}

float aroundVertex(const Skin& skin, const std::vector<float>& mask, uint v, MaskAct act) {
    float most = mask[v], least = mask[v], sum = 0.0f;
    for (const uint u : skin.ring(v)) {
        most = std::max(most, mask[u]);
        least = std::min(least, mask[u]);
        sum += mask[u] - mask[v];  // differences, so that an even mask stays as it is
    }
    if (act == MaskAct::grow) return most;
    if (act == MaskAct::shrink) return least;
    const float mean = mask[v] + sum / static_cast<float>(skin.ring(v).size() + 1);
    return std::clamp(mean, 0.0f, 1.0f);
}

// m; in a double, where any length times any scale is finite.
double worldLength(const Skin& skin, const Groom& groom, uint v) {
    return static_cast<double>(groom.fur[v].furLength) *
           static_cast<double>(skin.frames[skin.vertices[v].frame].scale);
}

// > 0 also where there is no hair.
double longestOf(const Skin& skin, const Groom& groom) {
    double longest = 1e-30;
    for (uint v = 0; v < skin.vertices.size(); ++v)
        longest = std::max(longest, worldLength(skin, groom, v));
    return longest;
}

std::vector<float> maskAfter(const SkinQuery& query, const Groom& groom, const MaskEdit& change) {
    const Skin& skin = query.skin();
    if (change.act == MaskAct::region) return regionWeights(query, groom, change.region);
    const double longest = change.act == MaskAct::length ? longestOf(skin, groom) : 0.0;
    std::vector<float> mask(skin.vertices.size());
    for (uint v = 0; v < mask.size(); ++v) {
        const FurVertex& fur = groom.fur[v];
        switch (change.act) {
            case MaskAct::invert:
                mask[v] = 1.0f - groom.mask[v];
                break;
            case MaskAct::clear:
                mask[v] = 0.0f;
                break;
            case MaskAct::fill:
                mask[v] = 1.0f;
                break;
            case MaskAct::length:
                mask[v] = static_cast<float>(worldLength(skin, groom, v) / longest);
                break;
            case MaskAct::density:
                mask[v] = fur.density;
                break;
            default:
                mask[v] = groom.mask[v];
        }
    }
    for (int ring = 0; byRings(change.act) && ring < change.rings; ++ring) {
        const std::vector<float> before = mask;
        for (uint v = 0; v < mask.size(); ++v) mask[v] = aroundVertex(skin, before, v, change.act);
    }
    return mask;
}

MaskEdit maskEditFrom(Words& words) {
    MaskEdit change;
    std::string_view word = words.next();
    const bool from = word == "from";
    if (from) word = words.next();
    for (std::size_t act = 0; act < kActs.size(); ++act) {
        change.act = static_cast<MaskAct>(act);
        const bool field = change.act == MaskAct::length || change.act == MaskAct::density;
        if (word != kActs[act] || field != from) continue;
        if (byRings(change.act) && !words.done())
            change.rings =
                static_cast<int>(numberAfter(words, word, 1.0f, static_cast<float>(kMostRings)));
        return change;
    }
    if (!from)
        throw std::runtime_error("the mask has no " + inQuotes(word) +
                                 "; it has invert, clear, fill, grow, shrink, smooth and from");
    change.act = MaskAct::region;
    change.region = regionNamed(word, words);
    return change;
}

}  // namespace

void applyMaskEdit(const SkinQuery& query, Groom& groom, const MaskEdit& change) {
    const std::vector<float> mask = maskAfter(query, groom, change);
    for (uint v = 0; v < mask.size(); ++v)
        if (groom.mask[v] != mask[v]) groom.mask.edit(v) = mask[v];
}

int ringsOf(const Skin& skin) {
    const double triangles = static_cast<double>(std::max<std::size_t>(skin.triangles.size(), 1));
    const double edge = std::sqrt(2.0 * skin.area / triangles);
    const double rings = static_cast<double>(kReach * skin.size()) / std::max(edge, 1e-30);
    return static_cast<int>(std::clamp(std::round(rings), 1.0, static_cast<double>(kMostRings)));
}

std::string maskLine(const MaskEdit& change) {
    if (change.act == MaskAct::region) return "mask from " + regionText(change.region);
    const bool field = change.act == MaskAct::length || change.act == MaskAct::density;
    return std::string("mask ") + (field ? "from " : "") +
           kActs[static_cast<std::size_t>(change.act)] +
           (byRings(change.act) ? ' ' + std::to_string(change.rings) : "");
}

void runMask(const SkinQuery& query, Editor& editor, Words& words) {
    const MaskEdit change = maskEditFrom(words);
    expectEnd(words);
    Groom groom = editor.document().groom;
    applyMaskEdit(query, groom, change);
    editor.edit([&](Document& document) { document.groom = std::move(groom); });
    const bool region = change.act == MaskAct::region;
    editor.commit(std::string("Mask: ") +
                  (region ? "a region" : kActs[static_cast<std::size_t>(change.act)]));
}

}  // namespace pelage
