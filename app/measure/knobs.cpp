// knobs.cpp -- the rows.
#include "app/measure/knobs.h"

#include <array>

namespace pelage {
namespace {

constexpr std::array kHairNames = {"1/8", "1/4", "1/2", "1"};
constexpr std::array kHairShares = {0.125f, 0.25f, 0.5f, 1.0f};

void turnHairs(std::size_t value, Fur&, View& view) {
    view.detail = {Detail::Rule::share, kHairShares[value], 0.0f};
}

constexpr std::array kDistanceNames = {"by distance"};

void turnDistance(std::size_t, Fur&, View& view) { view.detail.rule = Detail::Rule::distance; }

constexpr std::array kPixelNames = {"4 px", "2 px", "1 px", "0.5 px", "0.25 px"};
constexpr std::array kPixels = {4.0f, 2.0f, 1.0f, 0.5f, 0.25f};

void turnPixels(std::size_t value, Fur&, View& view) {
    view.detail = {Detail::Rule::pixels, kPixels[value], 0.0f};
}

constexpr std::array kFlipNames = {"0.1", "0.05", "0.02"};
constexpr std::array kFlips = {0.1f, 0.05f, 0.02f};

void turnFlip(std::size_t value, Fur&, View& view) {
    view.detail = {Detail::Rule::flip, kFlips[value], 0.0f};
}

void setStyle(Fur& fur, uint style) { fur.over.style = fur.under.style = style; }

constexpr std::array kSegmentNames = {"1", "2", "4", "8", "16"};
constexpr std::array kSegments = {1u, 2u, 4u, 8u, 16u};

void turnSegments(std::size_t value, Fur& fur, View& view) {
    setStyle(fur, kStylePolyline);
    view.segments = kSegments[value];
    view.tolerance = 1e6f;  // curls and frizz ask for no more than that
}

constexpr std::array kToleranceNames = {"10 px", "3 px", "1 px", "0.3 px", "0.1 px"};
constexpr std::array kTolerances = {10.0f, 3.0f, 1.0f, 0.3f, 0.1f};

void turnTolerance(std::size_t value, Fur& fur, View& view) {
    setStyle(fur, kStyleRibbon);
    view.tolerance = kTolerances[value];
}

constexpr std::array kStyleNames = {"line", "polyline", "ribbon", "nurbs-curve", "nurbs-surface"};

void turnStyle(std::size_t value, Fur& fur, View&) { setStyle(fur, static_cast<uint>(value)); }

constexpr std::array kSideNames = {"3", "4", "5", "6", "8"};
constexpr std::array kSides = {3u, 4u, 5u, 6u, 8u};

void turnSides(std::size_t value, Fur& fur, View& view) {
    setStyle(fur, kStyleTube);
    view.sides = kSides[value];
}

constexpr std::array kSampleNames = {"1", "4", "16", "64"};
constexpr std::array kSamples = {1, 4, 16, 64};

void turnSamples(std::size_t value, Fur&, View& view) { view.samples = kSamples[value]; }

constexpr std::array kCoatNames = {"strands", "strands/shells", "shells/strands", "shells"};

void turnCoats(std::size_t value, Fur&, View& view) {
    view.shells = Shells::swept;
    view.over = value & 2 ? DrawnAs::shells : DrawnAs::strands;
    view.under = value & 1 ? DrawnAs::shells : DrawnAs::strands;
}

constexpr std::array kLayerNames = {"8", "16", "32", "64"};
constexpr std::array kLayers = {8u, 16u, 32u, 64u};

template <Shells shells>
void turnLayers(std::size_t value, Fur&, View& view) {
    view.shells = shells;
    view.over = view.under = DrawnAs::shells;
    view.layers = kLayers[value];
}

void turnFins(std::size_t value, Fur& fur, View& view) {
    turnLayers<Shells::swept>(value, fur, view);
    view.over = view.under = DrawnAs::fins;
}

constexpr const char* kShellsLack =
    "clumps, curls and frizz; hairs stand elsewhere, and lean apart less";

constexpr std::array kTechniques = {
    Technique{"hairs", "share of the hairs (they get wider)", true, kHairNames, turnHairs,
              "edges of pixels beyond 16 samples; 16 segments for a curve"},
    Technique{"distance", "hairs thinned as the distance asks", false, kDistanceNames, turnDistance,
              "hairs thinner than a pixel, which fewer and wider ones stand for"},
    Technique{"detail", "deviation that is asked for", true, kPixelNames, turnPixels,
              "hairs thinner than that, which fewer and wider ones stand for"},
    Technique{"flip", "FLIP against all hairs that is asked for", true, kFlipNames, turnFlip,
              "what the eye hardly sees: hairs that fewer and wider ones stand for"},
    Technique{"segments", "segments of a polyline", true, kSegmentNames, turnSegments,
              "edges of pixels beyond 16 samples"},
    Technique{"ribbon", "deviation from the curve that is allowed", true, kToleranceNames,
              turnTolerance,
              "edges of pixels beyond 16 samples; the hair's round front, but for its mean"},
    Technique{"style", "how both coats are drawn", false, kStyleNames, turnStyle,
              "a line: the bend; a nurbs-curve: the change of color along the hair; ribbon and "
              "nurbs-surface: the sides of hair thinner than 1.5 pixels, but for their mean"},
    Technique{"sides", "sides of a tube", true, kSideNames, turnSides,
              "edges of pixels beyond 16 samples; what 8 sides lack of a round outline"},
    Technique{"samples", "frames in the mean", true, kSampleNames, turnSamples,
              "16 segments stand for a curve"},
    Technique{"coats", "technique of overcoat/undercoat", false, kCoatNames, turnCoats,
              kShellsLack},
    Technique{"shells", "layers at least, hair whole between them", false, kLayerNames,
              turnLayers<Shells::swept>, kShellsLack},
    Technique{"shells-fins", "layers at least, and fins on silhouettes", false, kLayerNames,
              turnFins, kShellsLack},
    Technique{"shells-plain", "layers, hair cut at each of them", true, kLayerNames,
              turnLayers<Shells::plain>, kShellsLack},
    Technique{"shells-instanced", "layers, for each the skin drawn once", true, kLayerNames,
              turnLayers<Shells::instanced>, kShellsLack},
};

constexpr std::array kNearnesses = {Nearness{"close", 0.25f}, Nearness{"middle", 1.0f},
                                    Nearness{"far", 6.0f}};

}  // namespace

std::span<const Technique> techniques() { return kTechniques; }

View measuredView() {
    View view;
    view.detail.rule = Detail::Rule::all;
    view.segments = 16;
    view.samples = 16;
    return view;
}

std::span<const Nearness> nearnesses() { return kNearnesses; }

}  // namespace pelage
