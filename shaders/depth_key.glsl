// depth_key.glsl -- window depth and a few bits of a hair's id in one word for atomicMin to order.

// depth in [0,1], 24 bits; the id breaks ties, so that the picture does not depend on which thread
// came first.
uint depthKey(float depth, uint id) {
    return (uint(clamp(depth, 0.0, 1.0) * 16777215.0) << 8u) | (id & 255u);
}
