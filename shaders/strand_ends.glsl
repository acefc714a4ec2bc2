// strand_ends.glsl -- the round ends of a hair in the window: the ends of a hair are balls.
//
// It reads and moves `points`: window position (pixels), depth, and width in pixels. `bulge` is how
// far a ball reaches beyond the end of the axis, in widths.

// Mean height of a half disc in diameters, pi / 8: so far the front of a round hair stands before its
// axis, and so far the ball at its end reaches beyond it.
const float kMeanBulge = 0.3926991;

#ifdef THIN

struct Front {    // of the round hair before its axis, in widths
    float rise;   // towards the eye
    float ahead;  // along the hair: what is seen at a place of the axis is nearer the tip where the
                  // hair points to the eye
};

// As the hair runs from its root to its tip; near its end, which looks at the eye, no further than
// where it makes 18 degrees with the view.
Front frontOf(Strand s, float bulge, vec3 eye) {
    vec2 k = strandWeights(s, 1.0);
    vec3 along = safeUnit(k.x * s.weightless + k.y * s.end, s.normal);
    float slope = clamp(dot(along, eye) / max(sineBetween(along, eye), 1e-3), -3.0, 3.0);
    return Front(bulge * sqrt(1.0 + slope * slope), bulge * slope);
}

void roundEnds(uint segments, float bulge) {
    vec2 step = points[1].xy - points[0].xy;
    points[0].xy -= bulge * points[0].w * inversesqrt(max(dot(step, step), 1e-12)) * step;
    step = points[segments].xy - points[segments - 1u].xy;
    points[segments].xy +=
        bulge * points[segments].w * inversesqrt(max(dot(step, step), 1e-12)) * step;
}

#else

struct Ends {     // pixels at both ends of the hair
    vec2 fronts;  // that show its first and last point
    vec2 balls;   // that have the width of its first and last point
};

// What is seen of a hair is its front: towards the root where it points to the eye. Its outline stays
// where it is.
Ends roundEnds(uint segments, float bulge, float zPerPixel) {
    float rootWidth = points[0].w;
    float tipWidth = points[segments].w;
    float pixelsPerZ = 1.0 / zPerPixel;
    Ends ends = Ends(vec2(0.0), vec2(0.0));
    vec2 ahead = vec2(0.0);  // unit, of the hair in the window
    float sine = 0.0;        // of its angle with the view
    float cosine = 0.0;
    float narrowing = 0.0;   // from pixel to pixel
    for (uint i = 0u; i <= segments; ++i) {
        vec4 p = points[i];
        if (i < segments) {
            vec4 step = points[i + 1u] - p;
            float across = dot(step.xy, step.xy);
            float towards = step.z * pixelsPerZ;
            float perPixel = inversesqrt(max(across, 1e-12));
            float perLength = inversesqrt(max(across + towards * towards, 1e-12));
            ahead = perPixel * step.xy;
            sine = across * perPixel * perLength;
            cosine = towards * perLength;
            narrowing = -step.w * perPixel;
        }
        float front = bulge * p.w;
        float back = front * cosine;
        if (i == 0u) {
            ends.fronts.x = front - back;
            ends.balls.x = back = front;
        } else if (i == segments) {
            ends.fronts.y = front + back;
            ends.balls.y = front;
            back = -front;
        } else {
            points[i].w = clamp(p.w + narrowing * back, tipWidth, rootWidth);
        }
        points[i].xy -= back * ahead;
#if STYLE != 4
        if (p.z > 0.0) points[i].z = max(p.z + sine * front * zPerPixel, 0.0);
#endif
    }
    return ends;
}

struct Along {     // shares of one segment
    vec2 moves;    // where the hair moves on: from, and how fast
    vec2 narrows;  // and where it changes its width
};

// Of the segment from point i, so many pixels long.
Along alongSegment(Ends ends, uint i, uint segments, float whole) {
    if (i > 0u && i + 1u < segments) return Along(vec2(0.0, 1.0), vec2(0.0, 1.0));
    whole = max(whole, 1e-3);
    vec2 first = i == 0u ? vec2(ends.fronts.x, ends.balls.x) / whole : vec2(0.0);
    vec2 last = i + 1u == segments ? vec2(ends.fronts.y, ends.balls.y) / whole : vec2(0.0);
    vec2 fast = 1.0 / max(1.0 - first - last, 1e-3);
    return Along(vec2(first.x, fast.x), vec2(first.y, fast.y));
}

#endif
