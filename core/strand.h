// strand.h -- the functions of strand.glsl and fiber.glsl that C++ may call, explained there.
#pragma once

#include "types.h"

namespace pelage {

uint pcg(uint v);
float rand01(uint v);
uint hairId(uint triangle, uint k, uint seed);
bool isOvercoat(uint id, float share);
vec3 safeUnit(vec3 v, vec3 fallback);
vec3 anyTangent(vec3 n);
vec3 baryWeights(uint bary);
vec3 randomInBall(uint id);
float arcOfUnitCurve(float m);

Strand bendStrand(vec3 root, vec3 n, vec3 painted, float spineLength, Coat coat, uint id,
                  vec3 gravityDirection, float gravity);
Strand growStrand(Root root, SkinVertex a, SkinVertex b, SkinVertex c, FurVertex fa, FurVertex fb,
                  FurVertex fc, Fur fur, float autoWidth);
vec2 strandWeights(float t);
vec3 strandPoint(Strand s, float t);
vec3 strandTangent(Strand s, float t);
vec3 strandNormal(Strand s, vec3 tangent);
float strandWidth(Strand s, float taper, float t);

float sineBetween(vec3 t, vec3 l);
float widthAbove(float taper, float t);
float depthInCoat(Fur fur, float hairsPerArea, float furLength, float overWidth, float underWidth,
                  uint coat, float t);
float keyThroughCoat(float depth, vec3 n, vec3 tangent, vec3 l);
float skyThroughCoat(float depth);
vec3 fiberRadiance(Strand s, Coat coat, Light light, vec3 base, float t, vec3 toEye, float depth);
vec3 skinRadiance(Light light, Coat under, vec3 base, vec3 n, float depth);

}  // namespace pelage
