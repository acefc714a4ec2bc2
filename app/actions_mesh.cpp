// actions_mesh.cpp -- edits of the whole mesh.
#include "app/actions.h"

namespace pelage {
namespace {

constexpr Action kActions[] = {
    {"mesh.subdivide",
     "Mesh",
     "Subdivide...",
     "",
     "Four triangles for each, so that the brushes reach finer; the fur stays.",
     {},
     askSubdivide,
     hasAnimal,
     nullptr},
    {"mesh.transfer",
     "Mesh",
     "Transfer groom from...",
     "",
     "Take the fur of another file over, from the nearest point of its skin.",
     {},
     [](App& app) { askForFile(app, Dialog::transfer); },
     hasAnimal,
     nullptr},
};

}  // namespace

std::span<const Action> meshActions() { return kActions; }

}  // namespace pelage
