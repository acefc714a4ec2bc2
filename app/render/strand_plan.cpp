// strand_plan.cpp -- what is chosen of the hair, as the strand pass reads it.
#include "app/render/strand_pass.h"

namespace pelage {
namespace {

constexpr uint kGroupSize = 32;  // local_size_x of strand_raster.comp

void append(StrandPlan& plan, const Cluster& cluster, const Choice::Drawn& drawn) {
    const auto run = static_cast<uint>(plan.runs.size());
    plan.runs.push_back({.first = cluster.first,
                         .begin = plan.end,
                         .end = plan.end + drawn.hairs,
                         .lod = drawn.lod,
                         .fade = drawn.fade,
                         .phase = cluster.phase,
                         .step = 1.0f / static_cast<float>(cluster.count)});
    plan.end += drawn.hairs;
    while (plan.groups.size() * kGroupSize < plan.end) plan.groups.push_back(run);
}

}  // namespace

StrandPlan planStrands(const Roots& roots, const Choice& choice, bool adapts) {
    StrandPlan plan;
    plan.thinRibbonsAreLines = adapts;
    for (const Choice::Drawn& drawn : choice.clusters)
        if (!drawn.narrow) append(plan, roots.clusters[drawn.cluster], drawn);
    plan.wideEnd = plan.end;
    plan.narrowBegin = plan.end = (plan.end + kGroupSize - 1) / kGroupSize * kGroupSize;
    for (const Choice::Drawn& drawn : choice.clusters)
        if (drawn.narrow) append(plan, roots.clusters[drawn.cluster], drawn);
    return plan;
}

}  // namespace pelage
