// mirror.h -- the GPU copy of a document. The only owner of its buffers.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "app/render/gl.h"
#include "app/render/level_task.h"
#include "core/document.h"
#include "core/lod.h"

namespace pelage {

struct CornerData {  // as Corner in shaders/frame.glsl
    vec2 uv{0.0f};
    uint color = ~0u;
    uint skinVertex = 0;
};

class Mirror {
public:
    // Makes the GPU's copy equal to the document, standing as `posed` (pose.h) where that is not
    // null. Uploads the skin when it is another one, roots when their number or seed changed, and
    // of the groom the chunks that are not those uploaded last; in another pose the vertices and
    // the fur, while roots, mask and segments stay. Returns true if anything differed.
    bool update(const Document& document, const std::shared_ptr<const Skin>& posed = nullptr);

    // Binds every buffer and texture of frame.glsl, the fur block, the mask, the segments and
    // the roots.
    void bind() const;

    const Roots& roots() const { return roots_; }
    const std::vector<Tuft>& tufts() const { return tufts_; }  // by cluster, as the skin stands
    struct Part {                                              // of the source
        uint firstTriangle = 0, triangleCount = 0;
        uint material = 0;
        float layer = -1.0f;  // of its base-color texture, -1 = none
    };
    const std::vector<Part>& parts() const { return parts_; }
    // Its triangles as it stands, and their corners in the order of the patches.
    struct Surface {
        Patches patches;
        gl::Buffer indices;
        gl::Texture rows;  // the same as texels
        void upload(const std::vector<uvec3>& triangles);
    };
    const Surface& surface() const { return fine_; }
    // Where edges may be off by `deviation` pixels. Levels are made when they are first needed:
    // beside the caller, who has a finer surface until then, or at once where he `waits`. There
    // are none in other poses than that at rest, and none of a skin that is no longer there.
    const Surface& surface(const Sight& sight, float deviation, bool waits);
    // In any pose: one that misses the skin at rest by at most `error` m, its patches those at
    // rest.
    const Surface& surfaceWithin(float error, bool waits);
    const gl::Buffer& corners() const { return corners_; }
    // As it stands.
    const Skin& skin() const { return *shown_; }
    const std::shared_ptr<const Skin>& shown() const { return shown_; }
    bool textured() const { return textured_; }
    float longestHair() const;  // m, of all vertices
    float usualHair() const;    // m, the median of the longest ones here and there
    std::size_t chunksUploaded() const { return chunksUploaded_; }  // by the last update
    std::size_t bytes() const;

private:
    void uploadSkin(const Skin& skin);
    void keep(int level, SkinLevel made);
    const Surface& surfaceOf(int level, bool waits);
    void uploadGroom(const Groom& groom, bool newSkin, bool newPose);
    void findChunks();
    void updateTufts(const std::vector<bool>& newChunks);

    std::shared_ptr<const Skin> skin_, shown_;  // at rest, and as it stands
    Groom groom_;
    Fur fur_{};
    Roots roots_;
    std::vector<Tuft> tufts_;
    std::vector<uvec2> chunksOf_;  // first and last chunk of the groom, by cluster
    bool textured_ = false;
    std::vector<Part> parts_;
    Surface fine_;
    std::map<int, Surface> coarse_;      // by level
    std::unique_ptr<LevelTask> making_;  // the next of them, of skin_
    std::size_t chunksUploaded_ = 0;
    std::vector<float> longestOfChunk_;
    gl::Buffer skinVertices_, furVertices_, triangles_, sourceTriangles_, corners_, materials_,
        mask_, segmentOf_, rootBuffer_, furBlock_;
    gl::Texture baseColors_;
};

}  // namespace pelage
