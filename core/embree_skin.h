// embree_skin.h -- what all uses of Embree share: its device, its errors, the skin's triangles,
// rays.
//
// Embree's own names for pointers to RTCDeviceTy and RTCSceneTy are RTCDevice and RTCScene.
#pragma once

#include <optional>

#include "skin.h"

struct RTCDeviceTy;
struct RTCSceneTy;
struct RTCRay;
struct RTCRayHit;

namespace pelage {

// Throws std::runtime_error where Embree cannot start.
RTCDeviceTy* newEmbreeDevice();

// Throws std::runtime_error that names what was built if the device has met an error since.
void checkEmbree(RTCDeviceTy* device, const char* what);

// Adds the triangles of a skin that outlives the scene, those without area so that no ray meets
// them.
void attachSkin(RTCDeviceTy* device, RTCSceneTy* scene, const Skin& skin);

// A ray that meets what is at least `nearest` away, in lengths of the direction.
RTCRay rayFrom(vec3 origin, vec3 direction, float nearest);

// What a ray meets first.
std::optional<RTCRayHit> firstHit(RTCSceneTy* scene, vec3 origin, vec3 direction);

}  // namespace pelage
