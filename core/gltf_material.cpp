// gltf_material.cpp -- materials, and the bytes of pictures wherever they are stored.
#include "gltf_material.h"

#include <cmath>
#include <stdexcept>

#include "beside.h"
#include "source_check.h"

namespace pelage {
namespace {

// Bytes of a picture in a file of its own, also kept for the export; none, with a warning, when it
// cannot be read.
std::vector<std::byte> externalPicture(GltfFile& file, const JsonPlace& image, std::size_t index,
                                       const std::string& uri) {
    pathBeside(file.path, uri);  // leaving the folder is refused, a missing file is not
    try {
        auto bytes = readBeside(file.path, uri, kMaxFileBytes - file.bytes);
        file.bytes += bytes.size();
        file.carried->images[index] = bytes;
        return bytes;
    } catch (const std::runtime_error& error) {
        file.warnings.add(image.text() + ": " + error.what());
        return {};
    }
}

// All images; those that no base color shows stay without bytes, except that the export embeds
// every external one.
void readImages(GltfFile& file, const std::vector<char>& shown, Source& source) {
    const std::size_t count = file.count("images");
    file.carried->images.resize(count);
    // Many images may name one view of a small file.
    std::size_t budget = (std::size_t{64} << 20) + 4 * file.bytes;
    for (std::size_t i = 0; i < count; ++i) {
        const JsonPlace image = file.element("images", i);
        SourceImage out{image.string("name"), {}};
        const std::string uri = image.string("uri");
        const auto view = image.reference("bufferView");
        if (view && shown[i]) {
            const auto bytes = viewBytes(file, *view);
            if (bytes.size() > budget)
                image.refuse("is one of too many large pictures for a file of this size");
            budget -= bytes.size();
            out.bytes.assign(bytes.begin(), bytes.end());
        } else if (uri.starts_with("data:")) {
            if (shown[i]) out.bytes = dataUriBytes(image, uri);
        } else if (!uri.empty()) {
            out.bytes = externalPicture(file, image, i, uri);
            if (!shown[i]) out.bytes.clear();
        }
        if (!out.bytes.empty() && !isPicture(out.bytes)) {
            file.warnings.add(image.text() + ": is neither PNG nor JPEG, so it is not shown");
            out.bytes.clear();
        }
        source.images.push_back(std::move(out));
    }
}

// KHR_texture_transform: translation * rotation * scale.
void readTransform(const JsonPlace& texture, BaseColorUvs& uvs) {
    const auto extensions = texture.object("extensions");
    const auto transform = extensions ? extensions->object("KHR_texture_transform") : std::nullopt;
    if (!transform) return;
    const auto offset = transform->numbers("offset", 2), scale = transform->numbers("scale", 2);
    const float angle = transform->numberOr("rotation", 0.0f);
    const vec2 s = scale.empty() ? vec2(1.0f) : vec2(scale[0], scale[1]);
    const float c = std::cos(angle), n = std::sin(angle);
    uvs.matrix[0] = vec3(c * s.x, -n * s.x, 0.0f);
    uvs.matrix[1] = vec3(n * s.y, c * s.y, 0.0f);
    if (!offset.empty()) uvs.matrix[2] = vec3(offset[0], offset[1], 1.0f);
    uvs.moved = true;
    uvs.set = transform->integerOr("texCoord", uvs.set, 1000);
}

}  // namespace

std::vector<BaseColorUvs> readMaterials(GltfFile& file, Source& source) {
    std::vector<char> shown(file.count("images"), 0);
    std::vector<BaseColorUvs> all;
    for (std::size_t m = 0; m < file.count("materials"); ++m) {
        const JsonPlace material = file.element("materials", m);
        SourceMaterial out;
        out.name = material.string("name");
        BaseColorUvs uvs;
        if (const auto surface = material.object("pbrMetallicRoughness")) {
            if (const auto f = surface->numbers("baseColorFactor", 4); !f.empty()) {
                out.baseColor = vec4(f[0], f[1], f[2], f[3]);
            }
            if (const auto texture = surface->object("baseColorTexture")) {
                uvs.set = texture->integerOr("texCoord", 0, 1000);
                readTransform(*texture, uvs);
                const std::size_t index = texture->integer("index", 0, 0xffffffffu);
                if (const auto image = file.element("textures", index).reference("source")) {
                    out.image = static_cast<int>(*image);
                    shown[*image] = 1;
                }
            }
        }
        source.materials.push_back(std::move(out));
        all.push_back(uvs);
    }
    readImages(file, shown, source);
    for (SourceMaterial& material : source.materials) {
        if (material.image >= 0 &&
            source.images[static_cast<std::size_t>(material.image)].bytes.empty()) {
            material.image = -1;
        }
    }
    return all;
}

}  // namespace pelage
