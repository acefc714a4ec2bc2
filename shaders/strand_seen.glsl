// strand_seen.glsl -- which hair an invocation draws, and the lists of those that the first pass
// found not hidden.
struct Run {     // a prefix of a cluster of roots
    uint first;  // into the roots
    uint begin;  // number of its first hair in the dispatch
    uint end;    // and of the first one after it
    float lod;   // share of the hairs that is drawn
    float fade;  // rank at which a hair of density 1 has faded out, >= lod
    float phase; // of the cluster's ranks
    float step;
    uint pad0;
};

struct List {   // of the hairs of one program that the first pass found not hidden
    uint wide;   // groups of 32 that the second pass dispatches, in this and two more dimensions
    uint high;
    uint deep;
    uint count;  // hairs
    uint segments;
};

layout(std430, binding = 9) readonly buffer Runs { Run runs[]; };
layout(std430, binding = 10) buffer Counters { List lists[]; };
layout(std430, binding = 11) buffer Seen { uint seenHairs[]; };  // numbers, list after list
layout(std430, binding = 12) readonly buffer Groups { uint groups[]; };  // run of the first of 32
#ifdef DEPTH_PASS
layout(location = 1) uniform uvec2 numbers;   // of the hairs: the first one, a multiple of 32, and
                                              // the one after the last
#endif
layout(location = 2) uniform uvec2 list;      // its number, and where it begins

const uint kNoHair = ~0u;

// Number of this invocation's hair.
uint hairNumber() {
    uint place = 32u * (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) +
                 gl_LocalInvocationID.x;
#ifdef DEPTH_PASS
    uint number = numbers.x + place;
    return number < numbers.y ? number : kNoHair;
#else
    return place < lists[list.x].count ? seenHairs[list.y + place] : kNoHair;
#endif
}

Run runOf(uint number) {
    uint which = groups[number / 32u];
    while (number >= runs[which].end) ++which;
    return runs[which];
}

#ifdef DEPTH_PASS
const uint kMostWide = 65535u;  // groups in one dimension, as in strand_pass.cpp

// Only these are grown again: in full groups, so that no lane idles for a hair that is hidden.
void keepSeen(uint number, uint segments) {
    atomicAdd(lists[list.x].segments, segments);
    uint place = atomicAdd(lists[list.x].count, 1u);
    seenHairs[list.y + place] = number;
    if (place % 32u != 0u) return;
    uint group = place / 32u;
    if (group < kMostWide) atomicAdd(lists[list.x].wide, 1u);
    if (group % kMostWide == 0u) atomicAdd(lists[list.x].high, 1u);
}
#endif
