// animated.h -- small glTF files that move, made by code.
#pragma once

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gltf_maker.h"
#include "test_skins.h"

namespace pelage::test {

// Adds one channel to an animation, which is made where there is none; its sampler.
inline nlohmann::json& addChannel(GltfMaker& maker, std::size_t animation, int node,
                                  const char* path, const std::vector<float>& times,
                                  const std::vector<float>& values,
                                  const char* interpolation = "LINEAR") {
    const std::string name = path;
    const char* type = name == "rotation" ? "VEC4" : name == "weights" ? "SCALAR" : "VEC3";
    const int input = maker.add<float>(times, "SCALAR", 5126);
    const int output = maker.add<float>(values, type, 5126);
    nlohmann::json& list = maker.json["animations"];
    while (list.size() <= animation)
        list.push_back(
            {{"channels", nlohmann::json::array()}, {"samplers", nlohmann::json::array()}});
    nlohmann::json& to = list[animation];
    to["channels"].push_back(
        {{"sampler", to["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    to["samplers"].push_back(
        {{"input", input}, {"output", output}, {"interpolation", interpolation}});
    return to["samplers"].back();
}

// A quarter turn about z as x, y, z, w.
inline const std::vector<float> kNoTurn{0.0f, 0.0f, 0.0f, 1.0f};
inline const std::vector<float> kQuarterTurn{0.0f, 0.0f, 0.70710678f, 0.70710678f};

inline std::vector<float> joined(std::vector<float> a, const std::vector<float>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// A sheet of 1 m in the plane y = 0, looking up, held by two joints at the origin: where x < -0.1
// by node 1, where x > 0.1 by its child, node 2, and by both in between. Clip "bend" turns node 2
// up by a quarter turn in 1 s. The node of the mesh stands elsewhere, which must not matter.
inline GltfMaker bendingSheet(uint cells) {
    const Source flat = sheet(cells);
    std::vector<float> positions, weights;
    std::vector<std::uint8_t> joints;
    std::vector<std::uint32_t> corners;
    for (const vec3 p : flat.positions) {
        const float second = std::clamp(5.0f * p.x + 0.5f, 0.0f, 1.0f);
        positions.insert(positions.end(), {p.x, p.y, p.z});
        weights.insert(weights.end(), {1.0f - second, second, 0.0f, 0.0f});
        joints.insert(joints.end(), {0, 1, 0, 0});
    }
    for (const uvec3 t : flat.triangles) corners.insert(corners.end(), {t.x, t.y, t.z});
    GltfMaker maker;
    const int position = maker.add<float>(positions, "VEC3", 5126);
    const int joint = maker.add<std::uint8_t>(joints, "VEC4", 5121);
    const int weight = maker.add<float>(weights, "VEC4", 5126);
    const int index = maker.add<std::uint32_t>(corners, "SCALAR", 5125);
    maker.mesh(
        {{"attributes", {{"POSITION", position}, {"JOINTS_0", joint}, {"WEIGHTS_0", weight}}},
         {"indices", index}});
    maker.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {3, 4, 5}}},
                           {{"name", "hip"}, {"children", {2}}},
                           {{"name", "tail"}}};
    maker.json["scenes"] = {{{"nodes", {0, 1}}}};
    maker.json["skins"] = {{{"joints", {1, 2}}}};
    addChannel(maker, 0, 2, "rotation", {0.0f, 1.0f}, joined(kNoTurn, kQuarterTurn));
    maker.json["animations"][0]["name"] = "bend";
    return maker;
}

// One triangle of three targets: "tall" lifts vertex 2, the second moves all, the third nothing.
inline GltfMaker morphing() {
    GltfMaker maker = GltfMaker::triangle();
    const int tall = maker.add<float>({0, 0, 0, 0, 0, 0, 0, 2, 0}, "VEC3", 5126);
    const int all = maker.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 5126);
    maker.primitive()["targets"] = {
        {{"POSITION", tall}}, {{"POSITION", all}}, nlohmann::json::object()};
    maker.json["meshes"][0]["extras"] = {{"targetNames", {"tall", 7}}};
    maker.json["meshes"][0]["weights"] = {0.5, 0, 0};
    return maker;
}

}  // namespace pelage::test
