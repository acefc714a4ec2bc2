// camera.h -- an orbiting camera and its matrices.
#pragma once

#include "core/types.h"

namespace pelage {

struct Camera {
    vec3 target{0.0f};         // m, world; what the camera looks at
    float distance = 1.0f;     // m from the target, > 0
    float yaw = 0.0f;          // rad; 0 looks along -z, from the front; grows to the animal's left
    float pitch = 0.0f;        // rad, [-pi/2, pi/2]; positive from above
    float fieldOfView = 0.6f;  // rad, vertical
    bool orthographic = false;

    bool operator==(const Camera&) const = default;

    vec3 eye() const;
    vec3 forward() const;  // unit
    vec3 right() const;    // unit
    vec3 up() const;       // unit
    mat4 view() const;
    // Depth range [-1, 1] (GL); near and far lie around a ball that holds the model and its hair.
    mat4 projection(float aspect, vec3 center, float radius) const;
};

// The camera that sees the whole ball from the given angles.
Camera framed(vec3 center, float radius, float yaw, float pitch, float aspect);

}  // namespace pelage
