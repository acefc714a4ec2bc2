// shell_source.h -- fur that is cut from one picture in place of hairs: a photograph, or any grey
// one.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "photo_layers.h"
#include "progress.h"
#include "shell_map.h"

namespace pelage {

// A picture as one texture with its levels; the next level has half of each side (halfSize).
struct ShellTexture {
    using Texel = std::array<unsigned char, 4>;

    bool photo = false;  // texels are colors, else the bytes of ShellTexels
    ivec2 size{0};
    std::vector<std::vector<Texel>> levels{};  // rows from the top
    ivec2 fileSize{0};                         // of the picture in its file; 0 without one

    std::size_t bytes() const;  // of all levels
};

// Larger pictures are halved until they fit. Any OpenGL 4.5 takes textures of 16384.
inline constexpr int kLargestSourceSide = 4096;

// A photograph as it is drawn: in 8 bits, of sides that fit, and each pixel either transparent or
// not at all.
Image drawnPhoto(Image photo);

// Of such a photograph: its colors, display-encoded, with an alpha of 255 in the region 0, 128 in
// the region 1 (colorRegions) and 0 where it is transparent. Averages alone would leave fur without
// tips or roots from afar, so that in each level the averages of a region are put in order, and the
// luminances of the photograph dealt out in that order: every layer of every level covers what it
// covers in the photograph, to a texel and the rounding to 8 bits.
ShellTexture photoTexture(const Image& photo, std::span<const unsigned char> regions);

// Of a map of full coverage that tapers to points: its heights, which are ranks (a share s of all
// is higher than 1 - sqrt(s)), and the ids of its hairs.
ShellTexture heightTexture(const ShellMap& map);

// Grey as it is displayed, which is what a painter of heights sees; 0 where there is nothing.
Plane greyOf(const Image& image);

// How the fur of one coat is drawn from a texture. Layer k of n lies k/n of the way in from the
// tips, the last one on the skin.
struct ShellSource {
    std::shared_ptr<const ShellTexture> texture;  // null = hairs
    uint layers = 16;                             // 1 to kMostLayers
    ShellCut cut{};                               // of grey pictures
    float gap = 1.0f;   // between two of them, of what fills the coat; (0,1]
    float side = 0.0f;  // m, the shorter side of the picture on the skin
    // Of a photograph: low and high luminance of each region; 0 = all of it is in layer 1.
    std::array<vec2, 2> tones{};

    float layerAt(uint k) const {  // share of the hair's length, from its root
        return gap * (1.0f - static_cast<float>(k) / static_cast<float>(layers));
    }
    bool operator==(const ShellSource&) const = default;
};

// What is asked for.
struct ShellRecipe {
    enum class From { hairs, photo, picture, noise };

    From from = From::hairs;
    std::string file{};    // of a photograph or picture
    PhotoOptions photo{};  // its layers are those of all kinds; never uniform
    NoisePattern noise{};
    ShellCut cut{};     // of noise and pictures
    float side = 0.0f;  // m; 0 = a fifth of the size of the skin
    float gap = 1.0f;

    bool operator==(const ShellRecipe&) const = default;
};

// What of it takes long to make, and does not depend on layers, range of tones, cut,
// side and gap.
struct ShellPicture {
    // A photograph with sides up to 1024, as drawn or a level of it, which holds the same tones;
    // empty for grey pictures.
    Image photo{};
    std::vector<unsigned char> regions{};  // of its pixels, as photoLayers takes them
    std::shared_ptr<const ShellTexture> texture{};
};
bool samePicture(const ShellRecipe& a, const ShellRecipe& b);

// Of a texture that is a photograph.
ShellPicture photoPicture(std::shared_ptr<const ShellTexture> texture);

// "8192x8192 pixels are drawn as 4096x4096"; empty for pictures that fit.
std::string halvedText(const ShellTexture& texture);

// Reads the file. Throws std::runtime_error as readImage does, and "a.png: all of 8x8 pixels are
// transparent" for a photograph; `recipe.from` is not hairs.
ShellPicture shellPicture(const ShellRecipe& recipe, Progress* progress = nullptr);
PhotoLayers photoLayers(const ShellPicture& picture, const PhotoOptions& options);
// `layers` of the photograph, if it is one.
ShellSource shellSource(const ShellPicture& picture, const ShellRecipe& recipe,
                        const PhotoLayers& layers, float skinSize);
// The same without what a panel shows of it.
ShellSource shellSource(const ShellPicture& picture, const ShellRecipe& recipe, float skinSize);

}  // namespace pelage
