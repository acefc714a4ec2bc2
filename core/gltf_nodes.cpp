// gltf_nodes.cpp -- walks the node trees with a list instead of recursion: depth comes from the
// file.
#include "gltf_nodes.h"

#include <cmath>

#include "text.h"

namespace pelage {
namespace {

constexpr std::size_t kAny = 0xffffffffu;

std::vector<std::size_t> indices(const JsonPlace& owner, const char* member) {
    std::vector<std::size_t> out;
    if (const auto list = owner.array(member)) {
        out.reserve(list->size());
        for (std::size_t i = 0; i < list->size(); ++i) out.push_back(list->at(i).integer(0, kAny));
    }
    return out;
}

NodePlace placeAsRead(const JsonPlace& node) {
    NodePlace place;
    if (const auto m = node.numbers("matrix", 16); !m.empty()) {
        mat4& out = place.matrix.emplace();
        for (int i = 0; i < 16; ++i) out[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
        return place;
    }
    if (const auto r = node.numbers("rotation", 4); !r.empty())
        place.rotation = vec4(r[0], r[1], r[2], r[3]);
    if (const auto s = node.numbers("scale", 3); !s.empty()) place.scale = vec3(s[0], s[1], s[2]);
    if (const auto t = node.numbers("translation", 3); !t.empty())
        place.translation = vec3(t[0], t[1], t[2]);
    return place;
}

bool isFinite(const mat4& m) {
    for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 4; ++r) {
            if (!std::isfinite(m[c][r])) return false;
        }
    }
    return true;
}

struct Tree {
    std::vector<std::vector<std::size_t>> children;
    std::vector<std::size_t> parent;
};

Tree readTree(const GltfFile& file) {
    Tree tree;
    const std::size_t count = file.count("nodes");
    tree.children.resize(count);
    tree.parent.assign(count, kNoNode);
    for (std::size_t n = 0; n < count; ++n) {
        const JsonPlace node = file.element("nodes", n);
        tree.children[n] = indices(node, "children");
        for (const std::size_t child : tree.children[n]) {
            if (tree.parent[child] != kNoNode) {
                node.refuse("child " + std::to_string(child) + " is already a child of node " +
                            std::to_string(tree.parent[child]));
            }
            tree.parent[child] = n;
        }
    }
    return tree;
}

// Nodes below these, themselves first, in the order in which a reader of the file meets them;
// without those seen before and what is below them.
std::vector<std::size_t> below(const Tree& tree, const std::vector<std::size_t>& roots,
                               std::vector<char>& seen) {
    std::vector<std::size_t> order;
    std::vector<std::size_t> open(roots.rbegin(), roots.rend());
    while (!open.empty()) {
        const std::size_t n = open.back();
        open.pop_back();
        if (seen[n]) continue;
        seen[n] = 1;
        order.push_back(n);
        open.insert(open.end(), tree.children[n].rbegin(), tree.children[n].rend());
    }
    return order;
}

std::vector<std::size_t> treeRoots(const Tree& tree) {
    std::vector<std::size_t> roots;
    for (std::size_t n = 0; n < tree.parent.size(); ++n) {
        if (tree.parent[n] == kNoNode) roots.push_back(n);
    }
    return roots;
}

std::string meshName(const GltfFile& file, std::size_t mesh) {
    const std::string name = file.element("meshes", mesh).string("name");
    return "mesh " + std::to_string(mesh) + (name.empty() ? "" : " " + inQuotes(name));
}

std::vector<std::size_t> placements(GltfFile& file, const Tree& tree) {
    const std::size_t meshes = file.count("meshes"), scenes = file.count("scenes");
    std::vector<std::size_t> placeOf(meshes, kNoNode), shown(meshes, 0);
    std::vector<char> seen(tree.parent.size(), 0);
    const auto meshOf = [&](std::size_t node) {
        return file.element("nodes", node).reference("mesh").value_or(kNoNode);
    };

    // The default scene places; without scenes the trees are all there is to show.
    const std::size_t first = file.root().integerOr("scene", 0, kAny);
    const auto roots =
        scenes == 0 ? treeRoots(tree) : indices(file.element("scenes", first), "nodes");
    for (const std::size_t n : below(tree, roots, seen)) {
        const std::size_t mesh = meshOf(n);
        if (mesh == kNoNode) continue;
        if (placeOf[mesh] == kNoNode) placeOf[mesh] = n;
        ++shown[mesh];
    }
    for (std::size_t m = 0; m < meshes; ++m) {
        if (shown[m] > 1) {
            file.warnings.add(meshName(file, m) + " is placed " + std::to_string(shown[m]) +
                              " times; all places share its fur, which is shown at the first");
        }
    }

    // Another scene places what the default one does not show.
    for (std::size_t s = 0; s < scenes; ++s) {
        if (s == first) continue;
        for (const std::size_t n : below(tree, indices(file.element("scenes", s), "nodes"), seen)) {
            const std::size_t mesh = meshOf(n);
            if (mesh == kNoNode || placeOf[mesh] != kNoNode) continue;
            placeOf[mesh] = n;
            file.warnings.add(meshName(file, mesh) +
                              " is not in the default scene; it is shown where scene " +
                              std::to_string(s) + " places it");
        }
    }
    for (std::size_t m = 0; m < meshes; ++m) {
        if (placeOf[m] == kNoNode) {
            file.warnings.add(meshName(file, m) + " is placed by no scene; it is shown as stored");
        }
    }
    return placeOf;
}

}  // namespace

Nodes readNodes(GltfFile& file) {
    const Tree tree = readTree(file);
    // With one parent at most, whatever no root leads to is on a ring or below one.
    std::vector<char> reached(tree.parent.size(), 0);
    Nodes nodes;
    nodes.tree.parent = tree.parent;
    nodes.tree.order = below(tree, treeRoots(tree), reached);
    nodes.tree.places.reserve(tree.parent.size());
    for (std::size_t n = 0; n < tree.parent.size(); ++n)
        nodes.tree.places.push_back(placeAsRead(file.element("nodes", n)));
    nodes.toWorld = worldMatrices(nodes.tree);
    for (const std::size_t n : nodes.tree.order) {
        if (!isFinite(nodes.toWorld[n]))
            file.element("nodes", n).refuse("its transform is too large for floats");
    }
    for (std::size_t n = 0; n < reached.size(); ++n) {
        if (!reached[n]) file.element("nodes", n).refuse("is its own ancestor");
    }
    nodes.placeOf = placements(file, tree);
    return nodes;
}

}  // namespace pelage
