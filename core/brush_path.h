// brush_path.h -- the path of a stroke and its mirror images, and how far vertices are from it.
#pragma once

#include <optional>
#include <vector>

#include "skin_query.h"
#include "surface_distance.h"

namespace pelage {

// Of the radius: paths are cut into pieces no longer than this.
inline constexpr float kLongestPiece = 1.0f / 3.0f;

struct PathPoint {
    vec3 position{0.0f};            // m, world
    vec3 normal{0.0f};              // world; of the skin there
    float pressure = 1.0f;          // [0,1]
    std::optional<SkinHit> foot{};  // the nearest place of the skin
};

// Zero for what has no direction.
vec3 unitOrZero(vec3 v);

struct Mirroring {
    mat4 matrix{1.0f};    // world
    bool turned = false;  // left and right are exchanged
};
// Those at the planes x = 0, y = 0 and z = 0 that `mirror` names and all their products, the
// identity first. The planes are those of the mesh's own space where all the skin is in one, else
// those of the world.
std::vector<Mirroring> mirrorings(const Skin& skin, glm::bvec3 mirror);

// The point with its foot: on a side of the skin that faces along the normal, where there is one
// and `facing` asks for it.
PathPoint onSkin(const SkinQuery& query, PathPoint point, bool facing);

// The mirror image of a point with a foot, moved so that its foot is on the skin, with the normal
// of the skin there.
PathPoint imageOf(const SkinQuery& query, const PathPoint& point, const mat4& mirroring,
                  bool facing);

// Where a vertex lies beside a piece of path, unrolled into a plane with the piece on its x axis.
struct Beside {
    double x = 0.0;  // m from the start of the piece
    double y = 0.0;  // m from its line; infinite for what no way leads to

    double distance(double along) const;  // m from a place of the piece
};

// One image of a path, the last piece of it: short, so that it counts as straight.
class PathImage {
public:
    // Goes on to the next point. With `alongSurface` it measures along the skin how far vertices
    // within `radius` of the piece are, and then the point counts as far from them as it is from
    // its foot. On open skin, where the way along it is nowhere longer than the straight line by
    // more than 5 % of the radius, one measurement serves the next third of the radius or more,
    // and the straight line counts.
    void advance(const SkinQuery& query, const PathPoint& to, bool alongSurface, float radius);

    const PathPoint& from() const { return from_; }
    const PathPoint& to() const { return to_; }
    vec3 start() const { return start_; }  // of the piece; on the skin when along it
    vec3 end() const { return end_; }
    double length() const { return length_; }  // m
    Beside beside(const SkinVertex& vertex, uint v) const;

private:
    void forget();
    double gapAt(double x) const;

    bool begun_ = false, alongSurface_ = true;
    PathPoint from_, to_;
    double length_ = 0.0;
    vec3 start_{0.0f}, end_{0.0f}, heading_{0.0f};  // of the piece; on the skin when along it
    double startGap_ = 0.0, endGap_ = 0.0;          // m from the points to their feet
    std::optional<vec3> open_;  // m, world; the middle of open skin, to which fromEnd_ belongs then
    SurfaceDistance fromStart_, fromEnd_;
};

}  // namespace pelage
