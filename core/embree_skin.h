// embree_skin.h -- what all uses of Embree share: its device, its errors, the skin's triangles.
//
// Embree's own names for pointers to RTCDeviceTy and RTCSceneTy are RTCDevice and RTCScene.
#pragma once

#include "skin.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace pelage {

// Throws std::runtime_error where Embree cannot start.
RTCDeviceTy* newEmbreeDevice();

// Throws std::runtime_error that names what was built if the device has met an error since.
void checkEmbree(RTCDeviceTy* device, const char* what);

// Adds the triangles of a skin that outlives the scene, those without area so that no ray meets
// them.
void attachSkin(RTCDeviceTy* device, RTCSceneTy* scene, const Skin& skin);

}  // namespace pelage
