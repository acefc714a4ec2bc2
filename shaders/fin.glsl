// fin.glsl -- what the passes that draw fins share: fur that stands on an edge of the skin near the
// silhouette.

// One for each edge and coat that has a fin in this view.
struct Fin {
    uint edge;     // 2 side + coat: half-edge (core/half_edges.h), 0 over and 1 under
    float weight;  // share of its hairs that is drawn
    float reach;   // m, from the edge to either side, that it stands for
    float wide;    // times as long as the edge: it stands for others too
};
layout(std430, binding = 12) buffer Fins {
    uint stripVertices;  // of each: the arguments of an indirect draw
    uint finCount;
    uint firstVertex;
    uint firstFin;
    Fin fins[];
};

const uint kFinQuads = 3u;  // of a strip, from root to tip

// Share of the hairs that the fin of an edge has, whose normal has this cosine with the view.
float finWeight(float cosine) { return 1.0 - smoothstep(0.0, 0.35, abs(cosine)); }

// Share of its width that a hair of a rank in [0,1) has in a fin of this weight.
float finWidth(float weight, float rank) {
    const float kFade = 0.25;
    return clamp(((1.0 + kFade) * weight - rank) / kFade, 0.0, 1.0);
}

// The first skin vertex of a half-edge.
uint beginOf(uint side) { return triangles[side / 3u][side % 3u]; }
uint nextOf(uint side) { return side - side % 3u + (side + 1u) % 3u; }
