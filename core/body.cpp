// body.cpp -- the list of segments and the brush that assigns them.
#include "body.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "brush.h"
#include "text.h"

namespace pelage {
namespace {

// N of "N", if there is a segment at that place.
uint placeFrom(std::string_view text, std::size_t count) {
    const auto number = wholeFromText(text);
    return number && *number < count ? *number : kNoSegment;
}

uint firstOfName(std::span<const Segment> body, std::string_view name) {
    const auto found = std::ranges::find(body, name, &Segment::name);
    return found == body.end() ? kNoSegment : static_cast<uint>(found - body.begin());
}

void expectFree(const Groom& groom, const std::string& name) {
    if (name.empty()) throw std::runtime_error("a body segment needs a name");
    if (firstOfName(groom.body(), name) != kNoSegment)
        throw std::runtime_error("there is a body segment " + inQuotes(name) + " already");
}

void expectAxis(vec3 root, vec3 tip) {
    const float length = glm::distance(root, tip);
    if (!(length > 0.0f) || !std::isfinite(length))
        throw std::runtime_error("the axis of a body segment needs a length");
}

template <class Change>
void change(Groom& groom, const Change& changeList) {
    std::vector<Segment> list(groom.body().begin(), groom.body().end());
    changeList(list);
    groom.segments = std::make_shared<const std::vector<Segment>>(std::move(list));
}

}  // namespace

uint segmentNamed(std::span<const Segment> body, std::string_view name) {
    if (body.empty()) throw std::runtime_error("the mesh has no body segments");
    uint found = kNoSegment;
    if (name.starts_with('#')) found = placeFrom(name.substr(1), body.size());
    if (found == kNoSegment) found = firstOfName(body, name);
    if (found == kNoSegment) found = placeFrom(name, body.size());
    if (found != kNoSegment) return found;
    std::string known;
    for (const Segment& segment : body)
        known += (known.empty() ? "" : ", ") + inQuotes(segment.name);
    throw std::runtime_error("no body segment " + inQuotes(name) + "; there are " + known);
}

std::string nameOfSegment(std::span<const Segment> body, uint segment) {
    assert(segment < body.size());
    const std::string& name = body[segment].name;
    const bool own = !name.empty() && name[0] != '#' && firstOfName(body, name) == segment;
    return own ? name : "#" + std::to_string(segment);
}

void addSegment(Groom& groom, const Segment& segment) {
    expectFree(groom, segment.name);
    expectAxis(segment.root, segment.tip);
    change(groom, [&](std::vector<Segment>& list) { list.push_back(segment); });
}

void moveSegment(Groom& groom, uint segment, vec3 root, vec3 tip) {
    expectAxis(root, tip);
    if (groom.body()[segment] == Segment{groom.body()[segment].name, root, tip}) return;
    change(groom, [&](std::vector<Segment>& list) {
        list[segment].root = root;
        list[segment].tip = tip;
    });
}

void renameSegment(Groom& groom, uint segment, const std::string& name) {
    if (groom.body()[segment].name == name) return;
    expectFree(groom, name);
    change(groom, [&](std::vector<Segment>& list) { list[segment].name = name; });
}

void removeSegment(Groom& groom, uint segment) {
    change(groom, [&](std::vector<Segment>& list) { list.erase(list.begin() + segment); });
    for (std::size_t v = 0; v < groom.segmentOf.size(); ++v) {
        const uint old = groom.segmentOf[v];
        if (old == kNoSegment || old < segment) continue;
        groom.segmentOf.edit(v) = old == segment ? kNoSegment : old - 1;
    }
}

SegmentPaint::SegmentPaint(const Skin& skin, const Groom& before, const Brush& brush) {
    if (!brush.segment.empty()) segment_ = segmentNamed(before.body(), brush.segment);
    if (brush.mode == Mode::subtract) giveBack(skin, before);
    least_ = 1.0f - brush.strength;
}

SegmentPaint::SegmentPaint(const Skin& skin, const Groom& before) { giveBack(skin, before); }

void SegmentPaint::giveBack(const Skin& skin, const Groom& before) {
    const Groom first = evenGroom(skin, kBareFur);
    source_ = first.segmentOf;
    const std::span<const Segment> was = first.body(), is = before.body();
    for (uint s = 0; s < was.size(); ++s)
        now_.push_back(s < is.size() && is[s].name == was[s].name ? s
                                                                  : firstOfName(is, was[s].name));
}

void SegmentPaint::paint(Groom& groom, uint v, float coverage) const {
    if (!(coverage > 0.0f) || coverage < least_ || groom.mask[v] >= 0.5f) return;
    uint segment = segment_;
    if (source_.size() > 0) segment = source_[v] == kNoSegment ? kNoSegment : now_[source_[v]];
    if (groom.segmentOf[v] != segment) groom.segmentOf.edit(v) = segment;
}

}  // namespace pelage
