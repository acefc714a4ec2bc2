// mesh_edits.cpp -- the verbs that change the mesh, or the fur of all of it, beside the main
// thread.
#include <filesystem>

#include "app/app.h"
#include "core/subdivide.h"
#include "core/transfer.h"

namespace pelage {
namespace {

constexpr int kOfferedLevels = 3;

}  // namespace

void askSubdivide(App& app) {
    app.dialogs.sizes = sizesAfterCuts(*app.skin().source, kOfferedLevels);
    app.dialogs.levels = 1;
    app.dialogs.current = Dialog::subdivide;
    trace(app, "asked subdivide");
}

void subdivideMesh(App& app, int levels) {
    cancelStroke(app);
    commitPending(app);
    startWork(
        app, "Subdividing the mesh",
        [&app, levels, document = app.document()](Progress& progress) -> Finish {
            auto after = std::make_shared<Document>(subdivided(document, levels, &progress));
            auto query = std::make_shared<std::unique_ptr<SkinQuery>>(
                std::make_unique<SkinQuery>(after->skin));
            return [&app, levels, after, query] {
                takeStep(app, std::move(*after), std::move(*query), kSubdivideLabel,
                         subdivideLine(levels));
                tell(app, "Subdivided: " + grouped(app.skin().source->positions.size()) +
                              " vertices, " + grouped(app.skin().triangles.size()) + " triangles");
            };
        },
        "Subdividing cancelled");
}

void transferFrom(App& app, const std::string& path) {
    cancelStroke(app);
    commitPending(app);
    const std::string absolute = std::filesystem::absolute(path).lexically_normal().string();
    startWork(
        app, "Transferring the groom",
        [&app, absolute, document = app.document()](Progress& progress) -> Finish {
            const Document from = openDocument(readSource(absolute, &progress), &progress);
            auto transfer = std::make_shared<Transferred>(transferred(from, document, &progress));
            return [&app, absolute, transfer] {
                const std::string note = farNote(*transfer);
                takeStep(app, std::move(transfer->document), nullptr, kTransferLabel,
                         transferLine(absolute));
                tell(app, note.empty() ? "Transferred the groom" : "Transferred; " + note);
            };
        },
        "Transfer cancelled");
}

}  // namespace pelage
