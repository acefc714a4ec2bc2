// shell_ground.h -- what shells know of the skin: the mean hair over it, and the surfaces that rays
// through the fur begin and end on.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "app/render/mirror.h"
#include "app/render/program.h"

namespace pelage {

class ShellGround {
public:
    ShellGround();
    // Brings it up to date for these coats, with the frame block and the mirror bound. The mean
    // hair stands as on a skin whose bumps are smoothed where they are smaller than it. `waits` as
    // for Mirror::surface.
    void update(Mirror& mirror, const Document& document, uint coats, float seconds, bool waits);

    // Triangles that miss the skin by a small part of the length of its usual hair: what the
    // surface over the fur is made of.
    const Mirror::Surface& furSurface() const { return *furSurface_; }
    const gl::Texture& vertices() const { return vertexRows_; }  // rows of a ShellVertex
    const gl::Texture& drawn() const { return drawnRows_; }      // rows of a ShellCorner
    const gl::Texture& corners() const { return cornerRows_; }   // a Corner each
    std::size_t bytes() const;

private:
    struct CurveKey {  // what the mean hair depends on
        std::shared_ptr<const Skin> shown;
        Groom groom;
        Fur fur;
        uint coats;
        float seconds, smoothed;
        bool operator==(const CurveKey&) const = default;
    };
    void updateVertices(const Mirror& mirror, const std::shared_ptr<const Skin>& atRest);
    void updateRest(const Mirror& mirror);
    void updateBends(const Mirror& mirror, float deviation);
    void findCurves(const Mirror& mirror, CurveKey key);

    Program curves_, rodCurves_;
    gl::Buffer vertices_, drawn_, rest_, bends_, rodTable_;
    gl::Texture vertexRows_, drawnRows_, cornerRows_;
    const Mirror::Surface* furSurface_ = nullptr;
    std::shared_ptr<const Skin> atRest_;  // whose vertices these are
    std::shared_ptr<const Skin> restOf_;  // from which to rest its vertices are turned
    std::shared_ptr<const Skin> shown_;   // whose bends are
    float smoothed_ = 0.0f;               // m, standard deviation
    std::optional<CurveKey> curvesOf_;
};

}  // namespace pelage
