// hard_cases.cpp -- the tables of hard meshes, furs and grooms.
#include "hard_cases.h"

#include <glm/gtc/matrix_transform.hpp>
#include <iterator>

#include "core/coat.h"

namespace pelage::test {
namespace {

// A plain sheet to which one hard thing is done.
template <class Change>
Source changedSheet(Change change) {
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
    addSheet(positions, triangles, 8, 0.0f, true);
    change(positions, triangles);
    return oneMesh(std::move(positions), std::move(triangles));
}

Source triangle(vec3 a, vec3 b, vec3 c) { return oneMesh({a, b, c}, {{0, 1, 2}}); }

using Positions = std::vector<vec3>;
using Triangles = std::vector<uvec3>;

std::vector<HardMesh> brokenSheets() {
    std::vector<HardMesh> all;
    const auto add = [&](const char* name, auto change) {
        all.push_back({name, changedSheet(change)});
    };
    add("faces of no area", [](Positions& p, Triangles& t) {
        for (std::size_t i = 0; i < t.size(); i += 3) t[i].y = t[i].x;        // a corner twice
        for (std::size_t i = 1; i < t.size(); i += 3) p[t[i].y] = p[t[i].x];  // one place
    });
    add("corners on a line", [](Positions& p, Triangles&) {
        for (std::size_t v = 0; v < p.size() / 2; ++v) p[v].z = -0.5f;
    });
    add("one face turned", [](Positions&, Triangles& t) { std::swap(t[20].x, t[20].y); });
    add("every second face turned", [](Positions&, Triangles& t) {
        for (std::size_t i = 0; i < t.size(); i += 2) std::swap(t[i].x, t[i].y);
    });
    add("faces twice", [](Positions&, Triangles& t) { t.insert(t.end(), t.begin(), t.end()); });
    add("both sides of the same corners", [](Positions&, Triangles& t) {  // normals cancel
        for (const uvec3 f : Triangles(t)) t.push_back({f.x, f.z, f.y});
    });
    add("three faces at an edge", [](Positions& p, Triangles& t) {
        p.push_back({0.0f, 1.0f, 0.0f});
        t.push_back({t[40].x, t[40].y, static_cast<uint>(p.size() - 1)});
    });
    add("corners that no face uses",
        [](Positions& p, Triangles&) { p.insert(p.end(), 100, vec3(1e6f)); });
    add("split along seams", [](Positions& p, Triangles& t) {
        for (uvec3& f : t)
            for (int c = 0; c < 3; ++c) {
                p.push_back(p[f[c]]);
                f[c] = static_cast<uint>(p.size() - 1);
            }
    });
    add("folded flat", [](Positions& p, Triangles&) {
        for (vec3& v : p) v.x = std::abs(v.x);
    });
    add("needles", [](Positions& p, Triangles&) {
        for (vec3& v : p) v.x *= 1e-3f;
    });
    add("finer needles", [](Positions& p, Triangles&) {
        for (vec3& v : p) v.x *= 1e-6f;
    });
    return all;
}

}  // namespace

std::vector<HardMesh> hardMeshes() {
    std::vector<HardMesh> all = brokenSheets();
    all.push_back({"one triangle", triangle({0, 0, 0}, {1, 0, 0}, {0, 0, 1})});
    all.push_back({"one needle", triangle({0, 0, 0}, {1, 0, 0}, {0.5f, 0, 1e-3f})});
    all.push_back(
        {"one needle askew", triangle({3, 1, 2}, {4, 1.5f, 2.25f}, {3.5f, 1.2501f, 2.125f})});
    all.push_back({"one triangle of no area", triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0})});
    all.push_back({"one point", triangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3})});

    const auto moved = [](vec3 by) { return glm::translate(mat4(1.0f), by); };
    const auto sized = [](vec3 by) { return glm::scale(mat4(1.0f), by); };
    mat4 sheared(1.0f);
    sheared[1] = vec4(2.0f, 1.0f, 0.5f, 0.0f);
    const std::pair<const char*, mat4> nodes[] = {
        {"1e-5 large", sized(vec3(1e-5f))},
        {"1e5 large", sized(vec3(1e5f))},
        {"faces of 0.01 m at 10 m", moved({10, -10, 10}) * sized(vec3(0.05f))},
        {"1 m at 1e5 m", moved({1e5f, 1e5f, -1e5f})},
        {"0.01 m at 1e5 m", moved({1e5f, 0, 0}) * sized(vec3(0.01f))},
        {"mirrored", sized({-1, 1, 1})},
        {"mirrored thrice", sized(vec3(-1))},
        {"stretched", sized({100, 1, 0.01f})},
        {"mirrored and stretched", sized({-1e3f, 1e-3f, 1})},
        {"sheared", sheared},
        {"flattened", sized({1, 0, 1})},
        {"shrunk to nothing", sized(vec3(0))},
        {"upside down", glm::rotate(mat4(1.0f), 3.1415927f, vec3(1, 0, 0))},
    };
    for (const auto& [name, toWorld] : nodes) {
        all.push_back({std::string("ball ") + name, ball(3)});
        all.back().source.parts[0].toWorld = toWorld;
    }
    return all;
}

void drawParameter(Fur& fur, Coat Fur::*coat, const Parameter& row, Draws& draws) {
    const uint kind = draws.below(4);
    vec3 value;
    for (int i = 0; i < 3; ++i) {
        // Often an end, otherwise evenly inside; small values of wide ranges have a turn of their
        // own.
        const float u = draws.in(0.0f, 1.0f);
        value[i] = kind == 0 ? row.least
                   : kind == 1
                       ? row.greatest
                       : row.least + (row.greatest - row.least) * (kind == 2 ? u : u * u * u);
    }
    if (coat)
        setParameter(fur.*coat, row, value);
    else
        setParameter(fur, row, value);
}

Fur drawnFur(Draws& draws) {
    Fur fur = defaultFur();
    const uint hairs = fur.hairs;
    for (const auto coat : {&Fur::over, &Fur::under})
        for (const Parameter& row : coatParameters()) drawParameter(fur, coat, row, draws);
    for (const Parameter& row : furParameters()) drawParameter(fur, nullptr, row, draws);
    fur.hairs = hairs;
    return fur;
}

Groom drawnGroom(const Skin& skin, float size, Draws& draws) {
    constexpr float kLengths[] = {0.0f, 1e-12f, 1e-6f, 1.0f, 1.0f, 1.0f, 30.0f, 1e6f};
    Groom groom = evenGroom(skin);
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const vec3 n = skin.vertices[v].normal;
        const vec3 around = safeUnit(draws.inBox(1.0f), n);
        const vec3 directions[] = {vec3(0),
                                   n,
                                   -n,
                                   vec3(0, 1, 0),
                                   vec3(0, -1, 0),
                                   around,
                                   0.5f * around,
                                   n + 1e-7f * around,
                                   -n + 1e-7f * around};
        FurVertex fur = kBareFur;
        fur.direction = directions[draws.below(std::size(directions))];
        fur.furLength = 0.04f * size * kLengths[draws.below(std::size(kLengths))];
        fur.density = draws.below(4) == 0 ? 0.0f : draws.in(0.0f, 2.0f);
        if (fur.density > 1.0f) fur.density = 1.0f;
        groom.fur.edit(v) = fur;
    }
    return groom;
}

}  // namespace pelage::test
