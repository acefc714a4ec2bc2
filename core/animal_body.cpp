// animal_body.cpp -- the only place that knows the animal's proportions: its pieces and segments.
#include "animal_body.h"

#include <algorithm>
#include <cmath>

namespace pelage::animal {
namespace {

// In the order of bodySegments(); a left part is followed by its right one.
enum SegmentId : uint {
    kHead,
    kMuzzle,
    kLeftEar,
    kRightEar,
    kNeck,
    kTrunk,
    kLeftArm,
    kRightArm,
    kLeftForearm,
    kRightForearm,
    kLeftHand,
    kRightHand,
    kLeftThigh,
    kRightThigh,
    kLeftShank,
    kRightShank,
    kLeftFoot,
    kRightFoot,
    kTail,
};

vec3 unit(vec3 v) { return v / std::sqrt(glm::dot(v, v)); }

// Joints, m. The left side (x > 0, the animal looks along +z) stands for both.
constexpr vec3 kNose{0.0f, 0.553f, 0.451f};
constexpr vec3 kMuzzleBase{0.0f, 0.565f, 0.345f};
constexpr vec3 kOcciput{0.0f, 0.620f, 0.185f};
constexpr vec3 kEarRoot{0.066f, 0.676f, 0.262f};
constexpr vec3 kEarTip{0.106f, 0.806f, 0.246f};
constexpr vec3 kWithers{0.0f, 0.430f, 0.140f};
constexpr vec3 kRump{0.0f, 0.385f, -0.235f};
constexpr vec3 kShoulder{0.056f, 0.350f, 0.128f};
constexpr vec3 kElbow{0.066f, 0.205f, 0.098f};
constexpr vec3 kWrist{0.064f, 0.062f, 0.122f};
constexpr vec3 kFingers{0.066f, 0.023f, 0.166f};
constexpr vec3 kHip{0.054f, 0.345f, -0.185f};
constexpr vec3 kKnee{0.080f, 0.222f, -0.115f};
constexpr vec3 kHock{0.072f, 0.135f, -0.232f};
constexpr vec3 kAnkle{0.070f, 0.050f, -0.205f};
constexpr vec3 kToes{0.072f, 0.023f, -0.152f};

struct TailPoint {
    vec3 place;
    float radius;
};

// The tail's middle line and its radius; t in [0,1] from the rump to the tip.
TailPoint tailPoint(float t) {
    constexpr vec3 kControl[4] = {{0.0f, 0.392f, -0.235f},
                                  {0.0f, 0.300f, -0.440f},
                                  {0.0f, 0.430f, -0.640f},
                                  {0.0f, 0.650f, -0.510f}};
    const float s = 1.0f - t;
    const vec3 place = s * s * s * kControl[0] + 3.0f * s * s * t * kControl[1] +
                       3.0f * s * t * t * kControl[2] + t * t * t * kControl[3];
    // A thin root, a full middle and a pointed tip.
    const float full = 0.033f + 0.120f * t * (1.0f - t) * (0.4f + t);
    return {place, full * (1.0f - 0.50f * t * t * t)};
}

Part cone(uint segment, vec3 a, float ra, vec3 b, float rb, float blend, float furLength) {
    Part part;
    part.segment = segment;
    part.a = a;
    part.b = b;
    part.ra = ra;
    part.rb = rb;
    part.blend = blend;
    part.furLength = furLength;
    part.comb = unit(b - a);
    part.end = 1.0f;
    return part;
}

Part ball(uint segment, vec3 middle, vec3 radii, float blend, float furLength, vec3 comb) {
    Part part;
    part.form = Form::ellipsoid;
    part.segment = segment;
    part.a = part.b = middle;
    part.radii = radii;
    part.blend = blend;
    part.furLength = furLength;
    part.comb = unit(comb);
    return part;
}

Part painted(Part part, Paint paint) {
    part.paint = paint;
    return part;
}

Part combed(Part part, vec3 comb) {
    part.comb = unit(comb);
    return part;
}

Part paired(Part part) {
    part.paired = true;
    part.sided = part.segment != kHead;
    return part;
}

void addTrunk(std::vector<Part>& parts) {
    const vec3 back(0.0f, -0.12f, -1.0f);
    parts.push_back(combed(
        cone(kTrunk, {0.0f, 0.368f, 0.120f}, 0.110f, {0.0f, 0.385f, -0.060f}, 0.094f, 0.0f, 0.042f),
        back));
    parts.push_back(combed(cone(kTrunk, {0.0f, 0.385f, -0.060f}, 0.094f, {0.0f, 0.377f, -0.180f},
                                0.099f, 0.07f, 0.044f),
                           back));
    parts.push_back(painted(ball(kTrunk, {0.0f, 0.358f, 0.172f}, {0.080f, 0.100f, 0.076f}, 0.05f,
                                 0.060f, {0, -1, -0.45f}),
                            Paint::ruff));
    parts.push_back(painted(combed(cone(kNeck, {0.0f, 0.548f, 0.225f}, 0.080f,
                                        {0.0f, 0.440f, 0.125f}, 0.098f, 0.06f, 0.052f),
                                   {0.0f, -0.75f, -0.65f}),
                            Paint::neck));
}

void addHead(std::vector<Part>& parts, float cell) {
    const auto head = [](Part part) { return painted(part, Paint::head); };
    parts.push_back(head(ball(kHead, {0.0f, 0.612f, 0.272f}, {0.114f, 0.100f, 0.106f}, 0.045f,
                              0.016f, {0, 0.1f, -1})));
    parts.push_back(paired(head(ball(kHead, {0.070f, 0.574f, 0.296f}, {0.060f, 0.052f, 0.058f},
                                     0.040f, 0.028f, {0.45f, -0.4f, -1}))));
    parts.push_back(head(combed(cone(kMuzzle, kMuzzleBase, 0.054f,
                                     kNose - vec3(0.0f, 0.004f, 0.022f), 0.0250f, 0.038f, 0.009f),
                                {0.0f, 0.1f, -1.0f})));
    parts.push_back(head(combed(cone(kMuzzle, {0.0f, 0.540f, 0.345f}, 0.040f,
                                     {0.0f, 0.530f, 0.412f}, 0.020f, 0.022f, 0.009f),
                                {0.0f, -0.2f, -1.0f})));
    const float thin = std::max(0.36f, std::min(1.0f, 0.6f * cell / 0.056f));
    Part ear = paired(
        painted(cone(kLeftEar, kEarRoot, 0.060f, kEarTip, 0.0170f, 0.020f, 0.012f), Paint::ear));
    ear.form = Form::ear;
    ear.rb = std::max(ear.rb, 0.37f * cell / thin);
    ear.radii = vec3(thin, cell < 0.03f ? 0.012f : 0.0f, 0.0f);
    const vec3 up = unit(ear.b - ear.a);
    const vec3 forward(0.42f, 0.05f, 1.0f);
    ear.facing = unit(forward - glm::dot(forward, up) * up);
    parts.push_back(ear);
    const float eye = std::max(0.0215f, 0.4f * cell);
    parts.push_back(paired(painted(
        ball(kHead, {0.0570f, 0.6120f, 0.3515f}, {eye, eye, eye}, 0.0035f, 0.004f, {0, 0.3f, -1}),
        Paint::eye)));
    const float nose = std::max(1.0f, 0.4f * cell / 0.017f);
    parts.push_back(painted(
        ball(kMuzzle, kNose, nose * vec3(0.0200f, 0.0155f, 0.0150f), 0.006f, 0.003f, {0, 0.1f, -1}),
        Paint::nose));
}

void addLegs(std::vector<Part>& parts, float cell) {
    const float least = 0.42f * cell;  // radius that the coarsest mesh still sees
    const auto limb = [&](uint segment, vec3 a, float ra, vec3 b, float rb, float blend,
                          float fur) {
        return paired(cone(segment, a, std::max(ra, least), b, std::max(rb, least), blend, fur));
    };
    const vec3 down(0.0f, -1.0f, -0.25f);
    const vec3 ahead(0.0f, -0.35f, 1.0f);
    parts.push_back(
        painted(combed(limb(kLeftArm, kShoulder, 0.066f, kElbow, 0.039f, 0.045f, 0.034f), down),
                Paint::limb));
    parts.push_back(
        painted(limb(kLeftForearm, kElbow, 0.038f, kWrist, 0.0255f, 0.025f, 0.020f), Paint::sock));
    parts.push_back(painted(combed(limb(kLeftHand, kWrist - vec3(0.0f, 0.030f, 0.0f), 0.031f,
                                        kFingers, 0.028f, 0.022f, 0.010f),
                                   ahead),
                            Paint::sock));
    parts.push_back(painted(
        combed(limb(kLeftThigh, kHip, 0.082f, kKnee, 0.053f, 0.05f, 0.038f), down), Paint::limb));
    parts.push_back(
        painted(limb(kLeftShank, kKnee, 0.050f, kHock, 0.0285f, 0.030f, 0.026f), Paint::limb));
    parts.push_back(
        painted(limb(kLeftFoot, kHock, 0.0285f, kAnkle, 0.0245f, 0.018f, 0.015f), Paint::sock));
    parts.push_back(painted(combed(limb(kLeftFoot, kAnkle - vec3(0.0f, 0.020f, 0.0f), 0.030f, kToes,
                                        0.028f, 0.022f, 0.010f),
                                   ahead),
                            Paint::sock));
    // Three toes on each paw.
    for (const bool front : {true, false}) {
        const vec3 tip = front ? kFingers : kToes;
        for (int toe = -1; toe <= 1; ++toe) {
            const float side = float(toe);
            const vec3 place = tip + vec3(0.0165f * side, -0.006f, 0.017f - 0.006f * side * side);
            Part part = ball(front ? kLeftHand : kLeftFoot, place, vec3(0.0125f, 0.0145f, 0.0165f),
                             0.006f, 0.007f, {0.0f, -0.35f, 1.0f});
            part.radii = glm::max(part.radii, vec3(0.42f * cell));
            parts.push_back(paired(painted(part, Paint::sock)));
        }
    }
}

void addTail(std::vector<Part>& parts, float cell) {
    constexpr int kPieces = 26;
    for (int i = 0; i < kPieces; ++i) {
        const float t0 = float(i) / kPieces, t1 = float(i + 1) / kPieces;
        const TailPoint from = tailPoint(t0), to = tailPoint(t1);
        const float least = 0.42f * cell;
        const float middle = 0.5f * (t0 + t1);
        const float fur =
            0.050f + 0.060f * std::min(1.0f, 2.5f * middle) - 0.020f * middle * middle;
        Part part = cone(kTail, from.place, std::max(from.radius, least), to.place,
                         std::max(to.radius, least), i == 0 ? 0.045f : 0.010f, fur);
        part.start = t0;
        part.end = t1;
        parts.push_back(painted(part, Paint::tail));
    }
}

vec3 mirrored(vec3 v) { return {-v.x, v.y, v.z}; }

}  // namespace

std::vector<Part> bodyParts(float cell) {
    std::vector<Part> parts;
    addTrunk(parts);
    addLegs(parts, cell);
    addTail(parts, cell);
    addHead(parts, cell);
    return parts;
}

std::vector<Segment> bodySegments() {
    std::vector<Segment> segments;
    const auto both = [&](const char* before, const char* after, vec3 root, vec3 tip) {
        segments.push_back({std::string(before) + "left" + after, root, tip});
        segments.push_back({std::string(before) + "right" + after, mirrored(root), mirrored(tip)});
    };
    segments.push_back({"head", kMuzzleBase, kOcciput});
    segments.push_back({"muzzle", kNose, kMuzzleBase});
    both("ear.", "", kEarRoot, kEarTip);
    segments.push_back({"neck", kOcciput, kWithers});
    segments.push_back({"trunk", kWithers, kRump});
    both("leg.front.", ".upper", kShoulder, kElbow);
    both("leg.front.", ".lower", kElbow, kWrist);
    both("leg.front.", ".foot", kWrist, kFingers);
    both("leg.back.", ".upper", kHip, kKnee);
    both("leg.back.", ".lower", kKnee, kHock);
    both("leg.back.", ".foot", kHock, kToes);
    segments.push_back({"tail", tailPoint(0.0f).place, tailPoint(1.0f).place});
    return segments;
}

}  // namespace pelage::animal
