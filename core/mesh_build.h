// mesh_build.h -- what the readers of mesh_in share: one part of polygons, and its picture.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "source.h"

namespace pelage {

// Makes the source of one mesh, polygon by polygon.
struct MeshBuild {
    MeshBuild(const std::string& path, const char* format);

    // Appends the polygon as a fan around its first corner; fewer than three corners make none.
    // Corners that name vertices not yet read are not looked at.
    void addPolygon(std::span<const uint> corners);

    // The source as one part; checks it.
    Source finish();

    std::string file;  // opens messages
    Source source;
    std::size_t concave = 0;     // polygons whose fan folds over
    std::size_t cornerless = 0;  // polygons of fewer than three corners
};

// Adds the picture that the file names, as the base color of all of it. Warns when it cannot be
// read or shown; does nothing when the source has no path.
void addPicture(Source& source, const std::string& reference);

// Reports now and then: at every 2^16th call.
struct Ticker {
    Progress* progress;
    std::size_t calls = 0;
    void tick(std::size_t done, std::size_t all) {
        if (progress && (++calls & 0xffff) == 0) {
            progress->report(static_cast<float>(done) / static_cast<float>(all + 1));
        }
    }
};

}  // namespace pelage
