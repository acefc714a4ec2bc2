// region_lines.cpp -- circles of a sphere, edges of a box, the lasso where it was drawn.
#include "app/region_lines.h"

#include <cmath>
#include <numbers>

#include "app/app.h"

namespace pelage {
namespace {

constexpr int kPieces = 64;  // of a circle
constexpr vec4 kColor{1.0f, 0.86f, 0.45f, 0.95f};
constexpr vec4 kFaint{1.0f, 0.86f, 0.45f, 0.4f};

struct Circle {
    vec3 center{0.0f}, x{0.0f}, y{0.0f};  // x and y are its radii
    vec4 color{1.0f};
};

void addCircle(const Circle& circle, std::vector<OverlayLine>& lines) {
    vec3 before = circle.center + circle.x;
    for (int i = 1; i <= kPieces; ++i) {
        const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / kPieces;
        const vec3 next = circle.center + std::cos(angle) * circle.x + std::sin(angle) * circle.y;
        lines.push_back({before, next, circle.color});
        before = next;
    }
}

void addSphere(const App& app, const Region& region, std::vector<OverlayLine>& lines) {
    const float radius = region.radius * app.skin().size();
    const float border = radius + region.falloff * app.skin().size();
    constexpr vec3 kAxes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < 3; ++i)
        addCircle({region.center, radius * kAxes[i], radius * kAxes[(i + 1) % 3], kColor}, lines);
    const Camera& camera = app.session.camera;
    addCircle({region.center, border * camera.right(), border * camera.up(), kFaint}, lines);
}

void addBox(const App& app, const Region& region, std::vector<OverlayLine>& lines) {
    const vec3 half = region.half * app.skin().size();
    for (int axis = 0; axis < 3; ++axis) {
        for (int corner = 0; corner < 4; ++corner) {
            vec3 a = half, b(0.0f);
            a[(axis + 1) % 3] *= corner & 1 ? 1.0f : -1.0f;
            a[(axis + 2) % 3] *= corner & 2 ? 1.0f : -1.0f;
            b = a;
            b[axis] = -a[axis];
            lines.push_back({region.center + a, region.center + b, kColor});
        }
    }
}

}  // namespace

void addRegionOutline(const App& app, std::vector<OverlayLine>& lines) {
    const Region& region = app.session.region;
    if (region.where == Where::sphere) addSphere(app, region, lines);
    if (region.where == Where::box) addBox(app, region, lines);
}

std::vector<vec3> lassoInWorld(const App& app) {
    const Region& region = app.session.region;
    std::vector<vec3> corners;
    if (region.where != Where::lasso) return corners;
    const vec4 middle = region.viewProjection * vec4(app.skin().center(), 1.0f);
    const mat4 back = glm::inverse(region.viewProjection);
    for (const vec2 at : region.polygon) {
        const vec4 corner = back * vec4(at, middle.z / middle.w, 1.0f);
        corners.push_back(vec3(corner) / corner.w);
    }
    return corners;
}

}  // namespace pelage
