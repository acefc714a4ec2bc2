// gltf_carry.cpp -- merges the buffers of a carried glTF and embeds its pictures.
#include "gltf_carry.h"

#include <stdexcept>

#include "fur_fields.h"

namespace pelage {
namespace {

// Where each buffer of the source begins in the one that is written.
std::vector<std::size_t> mergeBuffers(GlbDraft& draft, const CarriedGltf& carried) {
    OrderedJson& buffers = draft.json.at("buffers");
    if (buffers.size() != carried.buffers.size())
        throw std::runtime_error("export: " + std::to_string(carried.buffers.size()) +
                                 " buffers were read of " + std::to_string(buffers.size()));
    std::vector<std::size_t> start;
    OrderedJson others = OrderedJson::array();
    bool othersSaySomething = false;
    for (std::size_t b = 0; b < buffers.size(); ++b) {
        const auto length = buffers[b].at("byteLength").get<std::size_t>();
        const auto& bytes = carried.buffers[b];
        if (bytes.size() < length)
            throw std::runtime_error("export: buffer " + std::to_string(b) + " has " +
                                     std::to_string(bytes.size()) + " of " +
                                     std::to_string(length) + " bytes");
        draft.bin.resize((draft.bin.size() + 3) & ~std::size_t{3});
        start.push_back(draft.bin.size());
        draft.bin.insert(draft.bin.end(), bytes.begin(),
                         bytes.begin() + static_cast<std::ptrdiff_t>(length));
        buffers[b].erase("uri");
        if (b == 0) continue;
        buffers[b].erase("byteLength");
        othersSaySomething = othersSaySomething || !buffers[b].empty();
        others.push_back(buffers[b]);
    }
    OrderedJson merged = buffers[0];
    OrderedJson& extras = merged["extras"];
    if (othersSaySomething && (extras.is_null() || extras.is_object()))
        extras["mergedBuffers"] = others;
    if (extras.is_null()) merged.erase("extras");
    buffers = OrderedJson::array({merged});
    return start;
}

// Makes a place in a buffer of the source one in the merged buffer.
void moveView(OrderedJson& view, const std::vector<std::size_t>& start) {
    const auto buffer = view.at("buffer").get<std::size_t>();
    if (buffer == 0) return;  // lies where it lay
    view["buffer"] = 0;
    view["byteOffset"] = start.at(buffer) + view.value("byteOffset", std::size_t{0});
}

}  // namespace

GlbDraft carriedDraft(const CarriedGltf& carried) {
    // The reader has refused what is nested too deep to be printed. (A callback of the parser could
    // look again, but it takes time by the square of the elements of an array.)
    GlbDraft draft{OrderedJson::parse(carried.json), {}};
    if (draft.json.contains("buffers") && !draft.json["buffers"].empty()) {
        const std::vector<std::size_t> start = mergeBuffers(draft, carried);
        OrderedJson none = OrderedJson::array();
        OrderedJson& views = draft.json.contains("bufferViews") ? draft.json["bufferViews"] : none;
        for (OrderedJson& view : views) {
            moveView(view, start);
            // Compressed copies that some loaders prefer to the plain bytes.
            if (view.contains("extensions"))
                for (OrderedJson& extension : view["extensions"])
                    if (extension.contains("buffer")) moveView(extension, start);
        }
    }
    return draft;
}

void embedPictures(GlbDraft& draft, const CarriedGltf& carried) {
    for (std::size_t i = 0; i < carried.images.size(); ++i) {
        if (carried.images[i].empty()) continue;
        const std::string type = pictureType(carried.images[i]);
        if (type.empty()) continue;
        const std::size_t view =
            appendView(draft, carried.images[i], 0, "picture " + std::to_string(i));
        OrderedJson& image = draft.json.at("images").at(i);
        image.erase("uri");
        image["bufferView"] = view;
        image["mimeType"] = type;
    }
}

GlbDraft bareDraft(const Source& source) {
    if (!source.carried) return builtDraft(source);
    GlbDraft draft = carriedDraft(*source.carried);
    stripFields(draft, source.parts);
    embedPictures(draft, *source.carried);
    return draft;
}

}  // namespace pelage
