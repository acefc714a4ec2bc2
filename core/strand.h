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
float arcOfHelix(float radius, float turns);
float rankOf(uint i, float phase, float step);
float fadedWidth(float rank, float lod, float fade);
float spaceNoise(vec3 p);
vec3 pullAt(Fur fur, vec3 place, float seconds);

Strand bendStrand(vec3 root, vec3 n, vec3 painted, float spineLength, Coat coat, uint id,
                  vec3 pull);
Strand growStrand(Root root, SkinVertex a, SkinVertex b, SkinVertex c, FurVertex fa, FurVertex fb,
                  FurVertex fc, Fur fur, float autoWidth, float seconds);
Strand gatherStrand(Strand s, Strand guide, Coat coat);
bool isShaped(Strand s);
bool isShapedCoat(Coat coat);
float angleOf(float x, float y);
float cubeRoot(float x);
float rodColumn(float angle);
float rodRow(float load);
mat3x4 rodCurve(float column, float row);
vec2 rodWeights(mat3x4 rod, float t);
vec2 rodSlope(mat3x4 rod, float t);
float rodLength(mat3x4 rod);
float rodFade(float angle);
float rodLoadLike(float g);
float rodLoad(Coat coat, float c, float strength);
vec2 strandWeights(Strand s, float t);
vec2 guideWeights(Strand s, float t);
vec3 strandPoint(Strand s, float t);
vec3 spinePoint(Strand s, float t);
vec3 strandTangent(Strand s, float t);
vec3 strandNormal(Strand s, vec3 tangent);
float strandWidth(Strand s, float taper, float t);
vec3 tubeNormal(Strand s, vec3 tangent, uint k, uint sides);
float tubeScale(uint sides);
float chordError(Strand s, float segments);
uint segmentsFor(Strand s, float tolerance);

float sineBetween(vec3 t, vec3 l);
float widthAbove(float taper, float t);
float depthInCoat(Fur fur, float hairsPerArea, float furLength, float overWidth, float underWidth,
                  uint coat, float t);
float keyThroughCoat(float depth, vec3 n, vec3 tangent, vec3 l);
float skyThroughCoat(float depth);
vec3 sideNormal(Strand s, vec3 tangent, vec3 side);
float meanFacing(vec3 tangent, vec3 middle, vec3 l);
vec3 fiberRadiance(Strand s, Coat coat, Light light, vec3 base, float t, vec3 toEye, float depth);
vec3 roundRadiance(Strand s, Coat coat, Light light, vec3 base, float t, vec3 toEye, float depth);
vec3 skinRadiance(Light light, Coat under, vec3 base, vec3 n, float depth);

}  // namespace pelage
