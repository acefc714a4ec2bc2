// embree_skin.cpp -- Embree's device, its errors, the skin's triangles, rays.
#include "embree_skin.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace pelage {
namespace {

// Drops hits on triangles of no area. `geometryUserPtr` is the array of areas.
void rejectDegenerate(const RTCFilterFunctionNArguments* arguments) {
    const float* areas = static_cast<const float*>(arguments->geometryUserPtr);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] != -1) continue;
        const uint triangle = RTCHitN_primID(arguments->hit, arguments->N, i);
        if (!(areas[triangle] > 0.0f)) arguments->valid[i] = 0;
    }
}

}  // namespace

RTCDeviceTy* newEmbreeDevice() {
    const RTCDevice device = rtcNewDevice(nullptr);
    if (!device) throw std::runtime_error("cannot start Embree: no device");
    return device;
}

void checkEmbree(RTCDeviceTy* device, const char* what) {
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE) {
        throw std::runtime_error(std::string("cannot build the ") + what + ": Embree error " +
                                 std::to_string(static_cast<int>(error)));
    }
}

void attachSkin(RTCDeviceTy* device, RTCSceneTy* scene, const Skin& skin) {
    if (skin.triangles.empty()) return;
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_LOW);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               skin.vertices.data(), offsetof(SkinVertex, position),
                               sizeof(SkinVertex), skin.vertices.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               skin.triangles.data(), 0, sizeof(uvec3), skin.triangles.size());
    // Embree does not write through the pointer; its interface is older than const.
    rtcSetGeometryUserData(geometry, const_cast<float*>(skin.areas.data()));
    rtcSetGeometryIntersectFilterFunction(geometry, rejectDegenerate);
    rtcSetGeometryOccludedFilterFunction(geometry, rejectDegenerate);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

RTCRay rayFrom(vec3 origin, vec3 direction, float nearest) {
    RTCRay ray{};
    ray.org_x = origin.x;
    ray.org_y = origin.y;
    ray.org_z = origin.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tnear = nearest;
    ray.tfar = INFINITY;
    ray.mask = ~0u;
    return ray;
}

std::optional<RTCRayHit> firstHit(RTCSceneTy* scene, vec3 origin, vec3 direction) {
    RTCRayHit query{};
    query.ray = rayFrom(origin, direction, 0.0f);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return query;
}

}  // namespace pelage
