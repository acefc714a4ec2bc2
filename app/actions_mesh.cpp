// actions_mesh.cpp -- edits of the whole mesh.
#include "app/actions.h"

namespace pelage {
namespace {

bool open(const App& app) { return app.isOpen(); }

constexpr Action kActions[] = {
    {"mesh.subdivide",
     "Mesh",
     "Subdivide...",
     "",
     "Four triangles for each, so that the brushes reach finer; the fur stays.",
     {},
     askSubdivide,
     open,
     nullptr},
    {"mesh.transfer",
     "Mesh",
     "Transfer groom from...",
     "",
     "Take the fur of another file over, from the nearest point of its skin.",
     {},
     [](App& app) { askForFile(app, Dialog::transfer); },
     open,
     nullptr},
};

}  // namespace

std::span<const Action> meshActions() { return kActions; }

}  // namespace pelage
