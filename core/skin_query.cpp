// skin_query.cpp -- the only place that knows Embree.
#include "skin_query.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace pelage {
namespace {

// Vertices in one primitive of the radius queries: fewer primitives build faster, shorter runs
// test fewer vertices in vain.
constexpr std::size_t kRun = 32;

struct Box {
    vec3 lower, upper;
};

// The query is a little wider than asked, so that rounding inside the tree loses no vertex; the
// exact test follows.
constexpr float kSlack = 1.0001f;
constexpr float kFarthest = 1e18f;  // m; Embree ignores what lies beyond

void check(RTCDevice device, const char* what) {
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE) {
        throw std::runtime_error(std::string("cannot build the ") + what + ": Embree error " +
                                 std::to_string(static_cast<int>(error)));
    }
}

// Flags the vertices that triangles name, in order.
std::vector<uint> usedVertices(const Skin& skin) {
    std::vector<bool> used(skin.vertices.size(), false);
    for (const uvec3& t : skin.triangles) used[t.x] = used[t.y] = used[t.z] = true;
    std::vector<uint> found;
    found.reserve(skin.vertices.size());
    for (uint v = 0; v < skin.vertices.size(); ++v)
        if (used[v]) found.push_back(v);
    return found;
}

// Drops hits on triangles of no area. `geometryUserPtr` is the array of areas.
void rejectDegenerate(const RTCFilterFunctionNArguments* arguments) {
    const float* areas = static_cast<const float*>(arguments->geometryUserPtr);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] != -1) continue;
        const uint triangle = RTCHitN_primID(arguments->hit, arguments->N, i);
        if (!(areas[triangle] > 0.0f)) arguments->valid[i] = 0;
    }
}

void boundsOfRun(const RTCBoundsFunctionArguments* arguments) {
    const Box& box = static_cast<const Box*>(arguments->geometryUserPtr)[arguments->primID];
    RTCBounds& bounds = *arguments->bounds_o;
    bounds.lower_x = box.lower.x;
    bounds.lower_y = box.lower.y;
    bounds.lower_z = box.lower.z;
    bounds.upper_x = box.upper.x;
    bounds.upper_y = box.upper.y;
    bounds.upper_z = box.upper.z;
}

struct RunSearch {
    const std::vector<Box>* boxes;
    vec3 point;
    float radius;
    std::vector<uint> runs;
};

// Notes a run whose box the ball touches. The radius stays, hence false.
bool noteRun(RTCPointQueryFunctionArguments* arguments) {
    RunSearch& search = *static_cast<RunSearch*>(arguments->userPtr);
    const Box& box = (*search.boxes)[arguments->primID];
    const vec3 nearest = glm::clamp(search.point, box.lower, box.upper);
    const vec3 away = search.point - nearest;
    if (glm::dot(away, away) <= search.radius * search.radius)
        search.runs.push_back(arguments->primID);
    return false;
}

}  // namespace

struct SkinQuery::Scenes {
    std::shared_ptr<const Skin> skin;
    std::vector<uint> used;  // vertices that triangles name, rising; cut into runs of kRun
    std::vector<Box> boxes;  // m, one per run
    RTCDevice device = nullptr;
    RTCScene rays = nullptr, points = nullptr;

    explicit Scenes(std::shared_ptr<const Skin> of) : skin(std::move(of)) {}
    Scenes(const Scenes&) = delete;
    Scenes& operator=(const Scenes&) = delete;
    ~Scenes() {
        if (rays) rtcReleaseScene(rays);
        if (points) rtcReleaseScene(points);
        if (device) rtcReleaseDevice(device);
    }

    void buildRays();
    void buildPoints();
};

void SkinQuery::Scenes::buildRays() {
    rays = rtcNewScene(device);
    rtcSetSceneFlags(rays, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(rays, RTC_BUILD_QUALITY_LOW);
    if (!skin->triangles.empty()) {
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_LOW);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   skin->vertices.data(), offsetof(SkinVertex, position),
                                   sizeof(SkinVertex), skin->vertices.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   skin->triangles.data(), 0, sizeof(uvec3),
                                   skin->triangles.size());
        // Embree does not write through the pointer; its interface is older than const.
        rtcSetGeometryUserData(geometry, const_cast<float*>(skin->areas.data()));
        rtcSetGeometryIntersectFilterFunction(geometry, rejectDegenerate);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(rays, geometry);
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(rays);
    check(device, "ray hierarchy");
}

void SkinQuery::Scenes::buildPoints() {
    used = usedVertices(*skin);
    boxes.resize((used.size() + kRun - 1) / kRun);
    for (std::size_t run = 0; run < boxes.size(); ++run) {
        const std::size_t end = std::min(used.size(), (run + 1) * kRun);
        vec3 lower = skin->vertices[used[run * kRun]].position, upper = lower;
        for (std::size_t i = run * kRun + 1; i < end; ++i) {
            lower = glm::min(lower, skin->vertices[used[i]].position);
            upper = glm::max(upper, skin->vertices[used[i]].position);
        }
        boxes[run] = {lower, upper};
    }
    points = rtcNewScene(device);
    rtcSetSceneBuildQuality(points, RTC_BUILD_QUALITY_LOW);
    if (!boxes.empty()) {
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_LOW);
        rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
        rtcSetGeometryUserData(geometry, boxes.data());
        rtcSetGeometryBoundsFunction(geometry, boundsOfRun, nullptr);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(points, geometry);
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(points);
    check(device, "vertex hierarchy");
}

SkinQuery::SkinQuery(std::shared_ptr<const Skin> skin)
    : scenes_(std::make_unique<Scenes>(std::move(skin))) {
    scenes_->device = rtcNewDevice(nullptr);
    if (!scenes_->device) throw std::runtime_error("cannot start Embree: no device");
    scenes_->buildRays();
    scenes_->buildPoints();
}

SkinQuery::~SkinQuery() = default;
SkinQuery::SkinQuery(SkinQuery&&) noexcept = default;
SkinQuery& SkinQuery::operator=(SkinQuery&&) noexcept = default;

const Skin& SkinQuery::skin() const { return *scenes_->skin; }

std::optional<SkinHit> SkinQuery::cast(vec3 origin, vec3 direction) const {
    const float length = glm::length(direction);
    if (!(length > 0.0f) || !std::isfinite(length)) return std::nullopt;
    direction /= length;

    RTCRayHit query{};
    query.ray.org_x = origin.x;
    query.ray.org_y = origin.y;
    query.ray.org_z = origin.z;
    query.ray.dir_x = direction.x;
    query.ray.dir_y = direction.y;
    query.ray.dir_z = direction.z;
    query.ray.tfar = INFINITY;
    query.ray.mask = ~0u;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scenes_->rays, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    SkinHit hit;
    hit.triangle = query.hit.primID;
    hit.u = query.hit.u;
    hit.v = query.hit.v;
    hit.distance = query.ray.tfar;
    const uvec3 corners = skin().triangles[hit.triangle];
    const vec3 a = skin().vertices[corners.x].position;
    const vec3 b = skin().vertices[corners.y].position;
    const vec3 c = skin().vertices[corners.z].position;
    hit.position = (1.0f - hit.u - hit.v) * a + hit.u * b + hit.v * c;
    // In double: the squared area of a small triangle is far below the range of float.
    const glm::dvec3 across =
        glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    hit.normal = vec3(glm::normalize(across));
    if (glm::dot(hit.normal, direction) > 0.0f) hit.normal = -hit.normal;
    return hit;
}

void SkinQuery::within(vec3 point, float radius, std::vector<uint>& vertices) const {
    if (!(radius >= 0.0f)) return;
    RunSearch search{&scenes_->boxes, point, radius * kSlack, {}};
    RTCPointQuery query{};
    query.x = point.x;
    query.y = point.y;
    query.z = point.z;
    query.radius = std::min(search.radius, kFarthest);
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scenes_->points, &query, &context, noteRun, &search);

    // Runs lie in rising order of vertices, so sorting the few runs sorts what is found.
    std::sort(search.runs.begin(), search.runs.end());
    const std::vector<uint>& used = scenes_->used;
    for (const uint run : search.runs) {
        const std::size_t end = std::min(used.size(), (run + std::size_t{1}) * kRun);
        for (std::size_t i = run * kRun; i < end; ++i) {
            const vec3 away = skin().vertices[used[i]].position - point;
            if (glm::dot(away, away) <= radius * radius) vertices.push_back(used[i]);
        }
    }
}

}  // namespace pelage
