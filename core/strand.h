// strand.h -- the functions of strand.glsl and fiber.glsl that C++ may call. Their comments are there.
#pragma once

#include "types.h"

namespace pelage {

uint pcg(uint v);
float rand01(uint v);
uint hairId(uint triangle, uint k, uint seed);
vec3 safeUnit(vec3 v, vec3 fallback);
vec3 baryWeights(uint packed);
float arcOfUnitCurve(float m);

// The hair that grows from a root on a triangle with these corners; painted values in the world.
Strand growStrand(Root root, SkinVertex a, SkinVertex b, SkinVertex c, FurVertex fa, FurVertex fb,
                  FurVertex fc, Fur fur, float autoWidth);
vec3 strandPoint(Strand s, float t);
vec3 strandTangent(Strand s, float t);
vec3 strandNormal(Strand s, vec3 tangent);
float strandWidth(Strand s, float taper, float t);

vec3 fiberRadiance(Strand s, Coat coat, vec3 base, float t, vec3 toEye, float opticalDepth);

}  // namespace pelage
