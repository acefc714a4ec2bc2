// strand_ring.glsl -- a ribbon or tube across, at one point of the hair, as it is seen from the eye.
struct Ring {
    vec3 tangent;
    vec3 right;   // unit, across hair and view
    vec3 toward;  // unit, across the hair, towards the eye
};

Ring ringAt(Strand s, float t, vec3 eye) {
    Ring ring;
    ring.tangent = strandTangent(s, t);
    ring.right = safeUnit(cross(ring.tangent, eye), s.binormal);
    ring.toward = cross(ring.right, ring.tangent);
    return ring;
}

// Place of a corner of a tube in half widths: to the right and towards the eye.
vec2 cornerPlace(Strand s, Ring ring, uint k, uint sides) {
    vec3 normal = tubeNormal(s, ring.tangent, k, sides);
    return tubeScale(sides) * vec2(dot(normal, ring.right), dot(normal, ring.toward));
}
