// ray_scene.cpp -- skin and hair for rays, by Embree.
#include "ray_scene.h"

#include <embree3/rtcore.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>

#include "embree_skin.h"
#include "strand.h"

namespace pelage {
namespace {

constexpr float kNearest = 2e-6f;  // of the scene's radius: what lies nearer casts no shadow
constexpr uint kSkinGeometry = 0;  // attached first

// Embree hands a pointer to the first member to the filter.
struct ShadowContext {
    RTCIntersectContext embree;
    uint hairGeometry, segments;
    uint ownGeometry, own;  // hair or triangle that the ray starts on
    float share;
    uint seed;
};

// Lets light past the start of the ray and past hairs by chance. Asked twice about one hair it
// says the same, so that joints and the order of asking do not matter.
void letThrough(const RTCFilterFunctionNArguments* arguments) {
    const auto& context = *reinterpret_cast<const ShadowContext*>(arguments->context);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] != -1) continue;
        const uint geometry = RTCHitN_geomID(arguments->hit, arguments->N, i);
        uint number = RTCHitN_primID(arguments->hit, arguments->N, i);
        const bool hair = geometry == context.hairGeometry;
        if (hair) number /= context.segments;
        const bool own = geometry == context.ownGeometry && number == context.own;
        if (own || (hair && !(rand01(context.seed ^ pcg(number)) < context.share)))
            arguments->valid[i] = 0;
    }
}

bool countBytes(void* bytes, ssize_t more, bool) {
    *static_cast<std::atomic<ssize_t>*>(bytes) += more;
    return true;
}

bool goOn(void* progress, double) { return !static_cast<Progress*>(progress)->cancel; }

}  // namespace

struct RayScene::Parts {
    std::shared_ptr<const Skin> skin;
    uint segments = 1;
    std::atomic<ssize_t> bytes{0};
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    uint hairGeometry = RTC_INVALID_GEOMETRY_ID;
    vec3 center{0.0f};
    float radius = 0.0f;

    Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    void attachHairs(const Curves& curves, const std::vector<float>& tapers);
    void commit(Progress* progress);
};

void RayScene::Parts::attachHairs(const Curves& curves, const std::vector<float>& tapers) {
    const std::size_t hairs = curves.rootWidth.size();
    if (hairs == 0) return;
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
    auto* points = static_cast<vec4*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                              RTC_FORMAT_FLOAT4, sizeof(vec4),
                                                              curves.points.size()));
    // Embree takes segments whose numbers follow each other for neighbours on one hair.
    auto* starts = static_cast<uint*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, sizeof(uint), hairs * segments));
    checkEmbree(device, "buffers of the hairs");
    const float step = 1.0f / static_cast<float>(segments);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, hairs, 256), [&](const auto& range) {
        for (std::size_t h = range.begin(); h < range.end(); ++h) {
            const std::size_t first = h * (segments + 1);
            for (uint p = 0; p <= segments; ++p) {
                const float narrower = 1.0f - tapers[h] * static_cast<float>(p) * step;
                const float half = 0.5f * curves.rootWidth[h] * narrower;
                points[first + p] = vec4(curves.points[first + p], std::max(half, 0.0f));
                if (p < segments) starts[h * segments + p] = static_cast<uint>(first + p);
            }
        }
    });
    rtcCommitGeometry(geometry);
    hairGeometry = rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

void RayScene::Parts::commit(Progress* progress) {
    if (progress) rtcSetSceneProgressMonitorFunction(scene, goOn, progress);
    rtcCommitScene(scene);
    if (progress) {
        progress->report(progress->done);
        rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
    }
    checkEmbree(device, "hierarchy of hairs");
    RTCBounds bounds;
    rtcGetSceneBounds(scene, &bounds);
    if (!(bounds.lower_x <= bounds.upper_x)) return;
    const vec3 lower(bounds.lower_x, bounds.lower_y, bounds.lower_z);
    const vec3 upper(bounds.upper_x, bounds.upper_y, bounds.upper_z);
    center = 0.5f * (lower + upper);
    radius = 0.5f * glm::distance(lower, upper);
}

RayScene::RayScene(std::shared_ptr<const Skin> skin, const Curves& curves,
                   const std::vector<float>& tapers, Progress* progress)
    : parts_(std::make_unique<Parts>()) {
    Parts& p = *parts_;
    p.skin = std::move(skin);
    p.segments = curves.pointsPerHair - 1;
    p.device = newEmbreeDevice();
    rtcSetDeviceMemoryMonitorFunction(p.device, countBytes, &p.bytes);
    p.scene = rtcNewScene(p.device);
    rtcSetSceneFlags(p.scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                         RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    if (p.skin) attachSkin(p.device, p.scene, *p.skin);
    p.attachHairs(curves, tapers);
    p.commit(progress);
}

RayScene::~RayScene() = default;

std::optional<RayHit> RayScene::cast(vec3 origin, vec3 direction) const {
    const std::optional<RTCRayHit> met = firstHit(parts_->scene, origin, direction);
    if (!met) return std::nullopt;

    RayHit hit;
    hit.facing = glm::normalize(vec3(met->hit.Ng_x, met->hit.Ng_y, met->hit.Ng_z));
    if (glm::dot(hit.facing, direction) > 0.0f) hit.facing = -hit.facing;
    hit.onHair = met->hit.geomID == parts_->hairGeometry;
    if (hit.onHair) {
        const uint segment = met->hit.primID % parts_->segments;
        hit.number = met->hit.primID / parts_->segments;
        hit.t = (static_cast<float>(segment) + met->hit.u) / static_cast<float>(parts_->segments);
        hit.place = origin + met->ray.tfar * direction;
    } else {
        hit.number = met->hit.primID;
        hit.weights = vec3(1.0f - met->hit.u - met->hit.v, met->hit.u, met->hit.v);
        const uvec3 corners = parts_->skin->triangles[hit.number];
        for (int c = 0; c < 3; ++c)
            hit.place += hit.weights[c] * parts_->skin->vertices[corners[c]].position;
    }
    return hit;
}

bool RayScene::blocked(const RayHit& from, vec3 direction, float share, uint seed) const {
    ShadowContext context{};
    rtcInitIntersectContext(&context.embree);
    context.embree.filter = letThrough;
    context.hairGeometry = parts_->hairGeometry;
    context.segments = parts_->segments;
    context.ownGeometry = from.onHair ? parts_->hairGeometry : kSkinGeometry;
    context.own = from.number;
    context.share = share;
    context.seed = seed;
    RTCRay ray = rayFrom(from.place, direction, kNearest * parts_->radius);
    rtcOccluded1(parts_->scene, &context.embree, &ray);
    return ray.tfar < 0.0f;
}

vec3 RayScene::center() const { return parts_->center; }

float RayScene::radius() const { return parts_->radius; }

std::size_t RayScene::bytes() const { return static_cast<std::size_t>(parts_->bytes.load()); }

}  // namespace pelage
