// glb_uses.cpp -- walks all places of core glTF that name an accessor or a view.
#include "glb_uses.h"

#include <utility>

namespace pelage {
namespace {

void collect(const OrderedJson& object, const char* key, std::multiset<std::size_t>& numbers) {
    const auto found = object.find(key);
    if (found == object.end()) return;
    if (found->is_number()) numbers.insert(found->get<std::size_t>());
    if (found->is_object())
        for (const OrderedJson& below : *found) numbers.insert(below.get<std::size_t>());
}

const OrderedJson& listOf(const OrderedJson& object, const char* key) {
    static const OrderedJson none = OrderedJson::array();
    const auto found = object.find(key);
    return found == object.end() ? none : *found;
}

// Takes one of the equal numbers out.
void takeOne(std::multiset<std::size_t>& numbers, std::size_t number) {
    if (const auto found = numbers.find(number); found != numbers.end()) numbers.erase(found);
}

// What the file says of an array besides its values.
void keepWords(const OrderedJson& from, OrderedJson& to) {
    to.erase("name");
    for (const char* word : {"name", "extras"})
        if (from.contains(word)) to[word] = from[word];
}

}  // namespace

std::multiset<std::size_t> accessorUses(const OrderedJson& gltf) {
    std::multiset<std::size_t> used;
    for (const OrderedJson& mesh : listOf(gltf, "meshes"))
        for (const OrderedJson& primitive : listOf(mesh, "primitives")) {
            collect(primitive, "attributes", used);
            collect(primitive, "indices", used);
            for (const OrderedJson& target : listOf(primitive, "targets"))
                for (const OrderedJson& accessor : target) used.insert(accessor.get<std::size_t>());
        }
    for (const OrderedJson& animation : listOf(gltf, "animations"))
        for (const OrderedJson& sampler : listOf(animation, "samplers")) {
            collect(sampler, "input", used);
            collect(sampler, "output", used);
        }
    for (const OrderedJson& skin : listOf(gltf, "skins"))
        collect(skin, "inverseBindMatrices", used);
    return used;
}

std::multiset<std::size_t> viewUses(const OrderedJson& gltf) {
    std::multiset<std::size_t> used;
    for (const OrderedJson& accessor : listOf(gltf, "accessors")) {
        collect(accessor, "bufferView", used);
        const OrderedJson& sparse = listOf(accessor, "sparse");
        for (const char* part : {"indices", "values"})
            if (sparse.is_object()) collect(listOf(sparse, part), "bufferView", used);
    }
    for (const OrderedJson& image : listOf(gltf, "images")) collect(image, "bufferView", used);
    return used;
}

AccessorReplacer::AccessorReplacer(GlbDraft& draft)
    : draft_(draft), accessors_(accessorUses(draft.json)), views_(viewUses(draft.json)) {}

void AccessorReplacer::release(const OrderedJson& accessor) {
    if (accessor.contains("bufferView")) takeOne(views_, accessor["bufferView"]);
    if (!accessor.contains("sparse")) return;
    for (const char* part : {"indices", "values"})
        takeOne(views_, accessor["sparse"].at(part).at("bufferView"));
}

std::size_t AccessorReplacer::replace(std::size_t old) {
    OrderedJson& accessors = draft_.json.at("accessors");
    OrderedJson& views = draft_.json.at("bufferViews");
    OrderedJson& before = accessors.at(old);
    keepWords(before, accessors.back());
    const OrderedJson oldView = before.value("bufferView", OrderedJson());
    if (!oldView.is_null()) keepWords(views.at(oldView.get<std::size_t>()), views.back());
    takeOne(accessors_, old);
    if (accessors_.contains(old)) return accessors.size() - 1;

    release(before);
    before = accessors.back();
    accessors.erase(accessors.size() - 1);
    if (!oldView.is_null() && !views_.contains(oldView.get<std::size_t>())) {
        views.at(oldView.get<std::size_t>()) = views.back();
        views.erase(views.size() - 1);
        accessors.at(old)["bufferView"] = oldView;
    }
    return old;
}

void dropUnusedBytes(GlbDraft& draft) {
    OrderedJson& views = draft.json.at("bufferViews");
    for (const OrderedJson& view : views)
        if (view.contains("extensions")) return;
    std::vector<std::byte> kept;
    for (OrderedJson& view : views) {
        const auto first = draft.bin.begin() + view.value("byteOffset", std::ptrdiff_t{0});
        kept.resize((kept.size() + 3) & ~std::size_t{3});
        view["byteOffset"] = kept.size();
        kept.insert(kept.end(), first, first + view.at("byteLength").get<std::ptrdiff_t>());
    }
    draft.bin = std::move(kept);
}

}  // namespace pelage
