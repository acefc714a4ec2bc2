// skin_query.cpp -- where a ray meets the skin, and what of it lies near a point, by Embree.
#include "skin_query.h"

#include <embree3/rtcore.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "embree_skin.h"
#include "nearest_in_triangle.h"

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

// Puts each triangle of a fan after its neighbour where there is one.
void chain(std::span<uvec2> fan) {
    constexpr std::size_t kMost = 64;  // of a fan that is worth it
    if (fan.size() > kMost) return;
    for (std::size_t i = 1; i < fan.size(); ++i) {
        const auto next = std::find_if(fan.begin() + static_cast<std::ptrdiff_t>(i), fan.end(),
                                       [&](uvec2 pair) { return pair.x == fan[i - 1].y; });
        if (next != fan.end()) std::swap(*next, fan[i]);
    }
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

// Unit normal of a face; its winding decides the side. In double: the squared area of a small
// triangle is far below the range of float.
vec3 faceNormal(const Skin& skin, uvec3 corners) {
    const glm::dvec3 a(skin.vertices[corners.x].position), b(skin.vertices[corners.y].position),
        c(skin.vertices[corners.z].position);
    return vec3(glm::normalize(glm::cross(b - a, c - a)));
}

// On the side of the hair, which need not be that of the winding in a mirrored part.
vec3 hairNormal(const Skin& skin, uvec3 corners) {
    const vec3 normal = faceNormal(skin, corners);
    const vec3 hair = skin.vertices[corners.x].normal + skin.vertices[corners.y].normal +
                      skin.vertices[corners.z].normal;
    return glm::dot(normal, hair) < 0.0f ? -normal : normal;
}

struct NearestSearch {
    const Skin* skin;
    glm::dvec3 point;
    vec3 facing;
    double square = std::numeric_limits<double>::infinity();  // m^2, of the distance so far
    uint triangle = 0;
    TriangleWeights weights{};
};

// Keeps the triangle if it is nearer, or as near and earlier, and narrows the search to it.
bool noteNearest(RTCPointQueryFunctionArguments* arguments) {
    auto& search = *static_cast<NearestSearch*>(arguments->userPtr);
    const Skin& skin = *search.skin;
    const uint triangle = arguments->primID;
    if (!(skin.areas[triangle] > 0.0f)) return false;
    const uvec3 corners = skin.triangles[triangle];
    if (search.facing != vec3(0.0f) && !(glm::dot(hairNormal(skin, corners), search.facing) > 0.0f))
        return false;
    const glm::dvec3 a = glm::dvec3(skin.vertices[corners.x].position) - search.point;
    const glm::dvec3 b = glm::dvec3(skin.vertices[corners.y].position) - search.point;
    const glm::dvec3 c = glm::dvec3(skin.vertices[corners.z].position) - search.point;
    const TriangleWeights weights = nearestInTriangle(a, b, c);
    const glm::dvec3 away = a + weights.u * (b - a) + weights.v * (c - a);
    const double square = glm::dot(away, away);
    if (!(square < search.square || (square == search.square && triangle < search.triangle)))
        return false;
    search.square = square;
    search.triangle = triangle;
    search.weights = weights;
    arguments->query->radius = std::min(static_cast<float>(std::sqrt(square)) * kSlack, kFarthest);
    return true;
}

}  // namespace

struct SkinQuery::Scenes {
    std::shared_ptr<const Skin> skin;
    std::vector<uint> used;      // vertices that triangles name, rising; cut into runs of kRun
    std::vector<Box> boxes;      // m, one per run
    std::vector<uint> fanFirst;  // fan of vertex v: fans[fanFirst[v]] up to fans[fanFirst[v + 1]]
    std::vector<uvec2> fans;
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
    void buildFans();
};

void SkinQuery::Scenes::buildRays() {
    rays = rtcNewScene(device);
    rtcSetSceneFlags(rays, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(rays, RTC_BUILD_QUALITY_LOW);
    attachSkin(device, rays, *skin);
    rtcCommitScene(rays);
    checkEmbree(device, "ray hierarchy");
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
    checkEmbree(device, "vertex hierarchy");
}

// A triangle that names a vertex twice is no way to anywhere but along its one edge.
void SkinQuery::Scenes::buildFans() {
    fanFirst.assign(skin->vertices.size() + 2, 0);
    for (const uvec3 t : skin->triangles)
        for (int c = 0; c < 3; ++c) ++fanFirst[t[c] + 2];
    std::partial_sum(fanFirst.begin(), fanFirst.end(), fanFirst.begin());
    fans.resize(3 * skin->triangles.size());
    for (const uvec3 t : skin->triangles)
        for (int c = 0; c < 3; ++c) fans[fanFirst[t[c] + 1]++] = {t[(c + 1) % 3], t[(c + 2) % 3]};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, skin->vertices.size(), 4096),
                      [&](const auto& range) {
                          for (std::size_t v = range.begin(); v < range.end(); ++v)
                              chain({fans.data() + fanFirst[v], fans.data() + fanFirst[v + 1]});
                      });
}

SkinQuery::SkinQuery(std::shared_ptr<const Skin> skin)
    : scenes_(std::make_unique<Scenes>(std::move(skin))) {
    scenes_->device = newEmbreeDevice();
    scenes_->buildRays();
    scenes_->buildPoints();
    scenes_->buildFans();
}

SkinQuery::~SkinQuery() = default;
SkinQuery::SkinQuery(SkinQuery&&) noexcept = default;
SkinQuery& SkinQuery::operator=(SkinQuery&&) noexcept = default;

std::span<const uvec2> SkinQuery::fan(uint v) const {
    const uvec2* fans = scenes_->fans.data();
    return {fans + scenes_->fanFirst[v], fans + scenes_->fanFirst[v + 1]};
}

const Skin& SkinQuery::skin() const { return *scenes_->skin; }

std::optional<SkinHit> SkinQuery::cast(vec3 origin, vec3 direction) const {
    const float length = glm::length(direction);
    if (!(length > 0.0f) || !std::isfinite(length)) return std::nullopt;
    direction /= length;

    const std::optional<RTCRayHit> met = firstHit(scenes_->rays, origin, direction);
    if (!met) return std::nullopt;

    SkinHit hit;
    hit.triangle = met->hit.primID;
    hit.u = met->hit.u;
    hit.v = met->hit.v;
    hit.distance = met->ray.tfar;
    const uvec3 corners = skin().triangles[hit.triangle];
    const vec3 a = skin().vertices[corners.x].position;
    const vec3 b = skin().vertices[corners.y].position;
    const vec3 c = skin().vertices[corners.z].position;
    hit.position = (1.0f - hit.u - hit.v) * a + hit.u * b + hit.v * c;
    hit.normal = faceNormal(skin(), corners);
    if (glm::dot(hit.normal, direction) > 0.0f) hit.normal = -hit.normal;
    return hit;
}

std::optional<SkinHit> SkinQuery::nearest(vec3 point, vec3 facing) const {
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
        return std::nullopt;
    NearestSearch search{&skin(), glm::dvec3(point), facing};
    RTCPointQuery query{};
    query.x = point.x;
    query.y = point.y;
    query.z = point.z;
    query.radius = kFarthest;
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scenes_->rays, &query, &context, noteNearest, &search);
    if (!(search.square < std::numeric_limits<double>::infinity())) return std::nullopt;

    SkinHit hit;
    hit.triangle = search.triangle;
    hit.u = static_cast<float>(search.weights.u);
    hit.v = static_cast<float>(search.weights.v);
    hit.distance = static_cast<float>(std::sqrt(search.square));
    const uvec3 corners = skin().triangles[hit.triangle];
    const glm::dvec3 a(skin().vertices[corners.x].position);
    const glm::dvec3 b(skin().vertices[corners.y].position);
    const glm::dvec3 c(skin().vertices[corners.z].position);
    hit.position = vec3(a + search.weights.u * (b - a) + search.weights.v * (c - a));
    hit.normal = hairNormal(skin(), corners);
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
