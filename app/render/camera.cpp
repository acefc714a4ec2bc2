// camera.cpp -- an orbiting camera and its matrices.
#include "app/render/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace pelage {

vec3 Camera::forward() const {
    return -vec3(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
}

vec3 Camera::right() const { return {std::cos(yaw), 0.0f, -std::sin(yaw)}; }

vec3 Camera::up() const { return glm::cross(right(), forward()); }

vec3 Camera::eye() const { return target - distance * forward(); }

mat4 Camera::view() const {
    // Not lookAt: its cross product with +Y fails looking straight down.
    const mat3 axes(right(), up(), -forward());
    mat4 view = mat4(glm::transpose(axes));
    view[3] = vec4(-glm::transpose(axes) * eye(), 1.0f);
    return view;
}

mat4 Camera::projection(float aspect, vec3 center, float radius) const {
    const float depth = glm::dot(center - eye(), forward());
    const float far = std::max(depth + radius, 1e-3f * radius);
    if (orthographic) {
        const float top = distance * std::tan(0.5f * fieldOfView);
        return glm::ortho(-top * aspect, top * aspect, -top, top, depth - radius, far);
    }
    const float near = std::max(depth - radius, 1e-3f * far);
    return glm::perspective(fieldOfView, aspect, near, far);
}

Camera framed(vec3 center, float radius, float yaw, float pitch, float aspect) {
    Camera camera;
    camera.target = center;
    camera.yaw = yaw;
    camera.pitch = pitch;
    const float halfAngle = std::atan(std::tan(0.5f * camera.fieldOfView) * std::min(aspect, 1.0f));
    camera.distance = std::max(radius, 1e-6f) / std::sin(halfAngle);
    return camera;
}

}  // namespace pelage
