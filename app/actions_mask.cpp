// actions_mask.cpp -- operations on the whole mask.
#include <GLFW/glfw3.h>

#include "app/actions.h"

namespace pelage {
namespace {

template <MaskAct act>
void change(App& app) {
    editMask(app, {.act = act, .rings = ringsOf(app.skin())});
}

constexpr Action kActions[] = {
    {"mask.invert",
     "Mask",
     "Invert",
     "",
     "Free what is masked and mask what is free.",
     {{{GLFW_KEY_I, GLFW_MOD_CONTROL}}},
     change<MaskAct::invert>,
     hasAnimal,
     nullptr},
    {"mask.clear",
     "Mask",
     "Clear",
     "",
     "Mask nothing.",
     {{{GLFW_KEY_M, GLFW_MOD_ALT}}},
     change<MaskAct::clear>,
     hasAnimal,
     nullptr},
    {"mask.fill",
     "Mask",
     "Fill",
     "",
     "Mask all hair.",
     {},
     change<MaskAct::fill>,
     hasAnimal,
     nullptr},
    {"mask.grow",
     "Mask",
     "Grow",
     "",
     "Move the border of the mask outwards by a hundredth of the animal's size.",
     {},
     change<MaskAct::grow>,
     hasAnimal,
     nullptr,
     false,
     true},
    {"mask.shrink",
     "Mask",
     "Shrink",
     "",
     "Move the border of the mask inwards by a hundredth of the animal's size.",
     {},
     change<MaskAct::shrink>,
     hasAnimal,
     nullptr},
    {"mask.smooth",
     "Mask",
     "Smooth",
     "",
     "Soften the border of the mask.",
     {},
     change<MaskAct::smooth>,
     hasAnimal,
     nullptr},
    {"mask.length",
     "Mask",
     "From length",
     "",
     "Mask hair by its length: the longest in full.",
     {},
     change<MaskAct::length>,
     hasAnimal,
     nullptr,
     false,
     true},
    {"mask.density",
     "Mask",
     "From density",
     "",
     "Mask hair by its density.",
     {},
     change<MaskAct::density>,
     hasAnimal,
     nullptr},
    {"mask.region",
     "Mask",
     "From the region",
     "",
     "Mask what the Region panel names: a sphere, a segment, narrow or curved skin, a lasso.",
     {},
     [](App& app) { editMask(app, {.act = MaskAct::region, .region = app.session.region}); },
     hasAnimal,
     nullptr},
};

}  // namespace

std::span<const Action> maskActions() { return kActions; }

}  // namespace pelage
