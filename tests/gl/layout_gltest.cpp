// layout_gltest.cpp -- C++ structures lie in memory as the driver reads them.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "app/render/base_colors.h"
#include "app/render/frame_data.h"
#include "app/render/mirror.h"
#include "app/render/shell_data.h"
#include "app/render/shell_pictures.h"
#include "app/render/strand_pass.h"
#include "tests/gl/gl_context.h"

namespace pelage {
namespace {

struct Field {
    const char* name;
    std::size_t offset;
};
#define FIELD(type, field) \
    Field { #field, offsetof(type, field) }

constexpr std::size_t kMissing = ~std::size_t(0);

std::size_t property(GLuint program, GLenum interface, const std::string& name, GLenum what) {
    const GLuint index = glGetProgramResourceIndex(program, interface, name.c_str());
    if (index == GL_INVALID_INDEX) return kMissing;
    GLint value = 0;
    glGetProgramResourceiv(program, interface, index, 1, &what, 1, nullptr, &value);
    return static_cast<std::size_t>(value);
}

// Fields of the elements of a storage buffer that holds an array called `array` in a block called
// `block`. A field that C++ does not list is a failure too.
void expectElements(GLuint program, const std::string& block, const std::string& array,
                    std::size_t size, const std::vector<Field>& fields) {
    for (const Field& field : fields) {
        const std::string name = array + "[0]." + field.name;
        EXPECT_EQ(property(program, GL_BUFFER_VARIABLE, name, GL_OFFSET), field.offset) << name;
        EXPECT_EQ(property(program, GL_BUFFER_VARIABLE, name, GL_TOP_LEVEL_ARRAY_STRIDE), size)
            << name;
    }
    EXPECT_EQ(property(program, GL_SHADER_STORAGE_BLOCK, block, GL_NUM_ACTIVE_VARIABLES),
              fields.size())
        << block;
}

// A shader that stores one element of each structure, so that none of it is unused.
gl::ProgramName shaderOf(const std::string& type) {
    return test::computeProgram(test::shaderHead({"types.glsl"}) +
                                "layout(local_size_x = 1) in;\n" +
                                "layout(std430, binding = 0) buffer From { " + type +
                                " from[]; };\n" + "layout(std430, binding = 1) buffer Into { " +
                                type + " into[]; };\n" + "void main() { into[0] = from[1]; }\n");
}

const std::vector<Field> kSkinVertex{FIELD(SkinVertex, position), FIELD(SkinVertex, pad0),
                                     FIELD(SkinVertex, normal), FIELD(SkinVertex, frame)};
const std::vector<Field> kFurVertex{FIELD(FurVertex, direction), FIELD(FurVertex, furLength),
                                    FIELD(FurVertex, tint), FIELD(FurVertex, density)};
const std::vector<Field> kRoot{FIELD(Root, triangle), FIELD(Root, bary), FIELD(Root, id),
                               FIELD(Root, guide)};
const std::vector<Field> kCoat{FIELD(Coat, ambient),    FIELD(Coat, stiffness),
                               FIELD(Coat, diffuse),    FIELD(Coat, endRandomness),
                               FIELD(Coat, specular),   FIELD(Coat, normalRandomness),
                               FIELD(Coat, rootColor),  FIELD(Coat, directionWeight),
                               FIELD(Coat, tipColor),   FIELD(Coat, shininess),
                               FIELD(Coat, colorNoise), FIELD(Coat, width),
                               FIELD(Coat, taper),      FIELD(Coat, relativeLength),
                               FIELD(Coat, style),      FIELD(Coat, clump),
                               FIELD(Coat, clumpSize),  FIELD(Coat, clumpShape),
                               FIELD(Coat, curlRadius), FIELD(Coat, curlTurns),
                               FIELD(Coat, frizz),      FIELD(Coat, frizzWaves),
                               FIELD(Coat, droop),      FIELD(Coat, softness),
                               FIELD(Coat, pad0),       FIELD(Coat, pad1)};
const std::vector<Field> kFur{FIELD(Fur, over.ambient),
                              FIELD(Fur, over.stiffness),
                              FIELD(Fur, over.diffuse),
                              FIELD(Fur, over.endRandomness),
                              FIELD(Fur, over.specular),
                              FIELD(Fur, over.normalRandomness),
                              FIELD(Fur, over.rootColor),
                              FIELD(Fur, over.directionWeight),
                              FIELD(Fur, over.tipColor),
                              FIELD(Fur, over.shininess),
                              FIELD(Fur, over.colorNoise),
                              FIELD(Fur, over.width),
                              FIELD(Fur, over.taper),
                              FIELD(Fur, over.relativeLength),
                              FIELD(Fur, over.style),
                              FIELD(Fur, over.clump),
                              FIELD(Fur, over.clumpSize),
                              FIELD(Fur, over.clumpShape),
                              FIELD(Fur, over.curlRadius),
                              FIELD(Fur, over.curlTurns),
                              FIELD(Fur, over.frizz),
                              FIELD(Fur, over.frizzWaves),
                              FIELD(Fur, over.droop),
                              FIELD(Fur, over.softness),
                              FIELD(Fur, over.pad0),
                              FIELD(Fur, over.pad1),
                              FIELD(Fur, under.ambient),
                              FIELD(Fur, under.stiffness),
                              FIELD(Fur, under.diffuse),
                              FIELD(Fur, under.endRandomness),
                              FIELD(Fur, under.specular),
                              FIELD(Fur, under.normalRandomness),
                              FIELD(Fur, under.rootColor),
                              FIELD(Fur, under.directionWeight),
                              FIELD(Fur, under.tipColor),
                              FIELD(Fur, under.shininess),
                              FIELD(Fur, under.colorNoise),
                              FIELD(Fur, under.width),
                              FIELD(Fur, under.taper),
                              FIELD(Fur, under.relativeLength),
                              FIELD(Fur, under.style),
                              FIELD(Fur, under.clump),
                              FIELD(Fur, under.clumpSize),
                              FIELD(Fur, under.clumpShape),
                              FIELD(Fur, under.curlRadius),
                              FIELD(Fur, under.curlTurns),
                              FIELD(Fur, under.frizz),
                              FIELD(Fur, under.frizzWaves),
                              FIELD(Fur, under.droop),
                              FIELD(Fur, under.softness),
                              FIELD(Fur, under.pad0),
                              FIELD(Fur, under.pad1),
                              FIELD(Fur, gravityDirection),
                              FIELD(Fur, gravity),
                              FIELD(Fur, share),
                              FIELD(Fur, hairs),
                              FIELD(Fur, seed),
                              FIELD(Fur, windDirection),
                              FIELD(Fur, wind),
                              FIELD(Fur, gusts),
                              FIELD(Fur, gustRate),
                              FIELD(Fur, gustSize),
                              FIELD(Fur, skinColor),
                              FIELD(Fur, pad0)};
const std::vector<Field> kStrand{FIELD(Strand, origin),
                                 FIELD(Strand, spineLength),
                                 FIELD(Strand, weightless),
                                 FIELD(Strand, width),
                                 FIELD(Strand, end),
                                 FIELD(Strand, scale),
                                 FIELD(Strand, binormal),
                                 FIELD(Strand, cosTwist),
                                 FIELD(Strand, normal),
                                 FIELD(Strand, tone),
                                 FIELD(Strand, coat),
                                 FIELD(Strand, keep),
                                 FIELD(Strand, sinTwist),
                                 FIELD(Strand, id),
                                 FIELD(Strand, guideOffset),
                                 FIELD(Strand, clump),
                                 FIELD(Strand, guideWeightless),
                                 FIELD(Strand, clumpShape),
                                 FIELD(Strand, guideEnd),
                                 FIELD(Strand, curl),
                                 FIELD(Strand, curlTurns),
                                 FIELD(Strand, frizz),
                                 FIELD(Strand, frizzWaves),
                                 FIELD(Strand, style),
                                 FIELD(Strand, rod),
                                 FIELD(Strand, guideRod),
                                 FIELD(Strand, droop),
                                 FIELD(Strand, rodBend),
                                 FIELD(Strand, nearSkin),
                                 FIELD(Strand, pad0)};
const std::vector<Field> kLight{FIELD(Light, toKey), FIELD(Light, key),    FIELD(Light, sky),
                                FIELD(Light, pad0),  FIELD(Light, ground), FIELD(Light, pad1)};

TEST(Layout, SharedStructuresLieAsTheDriverReadsThem) {
    const struct {
        const char* type;
        std::size_t size;
        const std::vector<Field>& fields;
    } structures[] = {
        {"SkinVertex", sizeof(SkinVertex), kSkinVertex},
        {"FurVertex", sizeof(FurVertex), kFurVertex},
        {"Root", sizeof(Root), kRoot},
        {"Coat", sizeof(Coat), kCoat},
        {"Fur", sizeof(Fur), kFur},
        {"Strand", sizeof(Strand), kStrand},
        {"Light", sizeof(Light), kLight},
    };
    for (const auto& s : structures) {
        const gl::ProgramName program = shaderOf(s.type);
        SCOPED_TRACE(s.type);
        expectElements(program.name(), "From", "from", s.size, s.fields);
        expectElements(program.name(), "Into", "into", s.size, s.fields);
    }
}

TEST(Layout, BuffersOfTheStrandPassLieAsTheDriverReadsThem) {
    const Program program = Program::compute("strand_raster.comp");
    const struct {
        const char *block, *array;
        std::size_t size;
        std::vector<Field> fields;
    } blocks[] = {
        {"Runs",
         "runs",
         sizeof(StrandPlan::Run),
         {FIELD(StrandPlan::Run, first), FIELD(StrandPlan::Run, begin), FIELD(StrandPlan::Run, end),
          FIELD(StrandPlan::Run, lod), FIELD(StrandPlan::Run, fade), FIELD(StrandPlan::Run, phase),
          FIELD(StrandPlan::Run, step), Field{"pad0", offsetof(StrandPlan::Run, pad)}}},
        {"Counters",
         "lists",
         sizeof(SeenList),
         {FIELD(SeenList, wide), FIELD(SeenList, high), FIELD(SeenList, deep),
          FIELD(SeenList, count), FIELD(SeenList, segments)}},
        {"Materials",
         "materials",
         sizeof(MaterialData),
         {FIELD(MaterialData, color), FIELD(MaterialData, layer)}},
        {"Corners",
         "corners",
         sizeof(CornerData),
         {FIELD(CornerData, uv), FIELD(CornerData, color), FIELD(CornerData, skinVertex)}},
        {"SkinVertices", "skinVertices", sizeof(SkinVertex), kSkinVertex},
        {"FurVertices", "furVertices", sizeof(FurVertex), kFurVertex},
        {"RootsBuffer", "roots", sizeof(Root), kRoot},
    };
    for (const auto& b : blocks) expectElements(program.name(), b.block, b.array, b.size, b.fields);
}

// Fields of a std140 block; names begin with `prefix`.
void expectUniforms(GLuint program, const std::string& block, const std::string& prefix,
                    std::size_t size, const std::vector<Field>& fields) {
    for (const Field& field : fields) {
        const std::string name = prefix + field.name;
        EXPECT_EQ(property(program, GL_UNIFORM, name, GL_OFFSET), field.offset) << name;
    }
    EXPECT_EQ(property(program, GL_UNIFORM_BLOCK, block, GL_NUM_ACTIVE_VARIABLES), fields.size())
        << block;
    EXPECT_EQ(property(program, GL_UNIFORM_BLOCK, block, GL_BUFFER_DATA_SIZE), size) << block;
}

TEST(Layout, UniformBlocksLieAsTheDriverReadsThem) {
    const Program program = Program::compute("strand_raster.comp");
    expectUniforms(program.name(), "FurBlock", "fur.", sizeof(Fur), kFur);
    expectUniforms(program.name(), "FrameBlock", "FrameBlock.", sizeof(FrameData),
                   {FIELD(FrameData, viewProjection), FIELD(FrameData, eye),
                    FIELD(FrameData, pixelsPerMetre), FIELD(FrameData, forward),
                    FIELD(FrameData, perspective),    FIELD(FrameData, light.toKey),
                    FIELD(FrameData, light.key),      FIELD(FrameData, light.sky),
                    FIELD(FrameData, light.pad0),     FIELD(FrameData, light.ground),
                    FIELD(FrameData, light.pad1),     FIELD(FrameData, overlayRange),
                    FIELD(FrameData, overlay),        FIELD(FrameData, segments),
                    FIELD(FrameData, size),           FIELD(FrameData, overWidth),
                    FIELD(FrameData, underWidth),     FIELD(FrameData, hairsPerArea),
                    FIELD(FrameData, coats),          FIELD(FrameData, textured),
                    FIELD(FrameData, adapts),         FIELD(FrameData, seconds),
                    FIELD(FrameData, tolerance),      FIELD(FrameData, sides)});
}

TEST(Layout, BuffersOfTheShellPassLieAsTheDriverReadsThem) {
    const Program program = Program::compute("shell_curves.comp");
    const struct {
        const char *block, *array;
        std::size_t size;
        std::vector<Field> fields;
    } blocks[] = {
        {"ShellVertices",
         "shellVertices",
         sizeof(ShellVertex),
         {FIELD(ShellVertex, position),    FIELD(ShellVertex, top),
          FIELD(ShellVertex, normal),      FIELD(ShellVertex, density),
          FIELD(ShellVertex, overA),       FIELD(ShellVertex, furLength),
          FIELD(ShellVertex, overB),       FIELD(ShellVertex, bendXX),
          FIELD(ShellVertex, underA),      FIELD(ShellVertex, bendXY),
          FIELD(ShellVertex, underB),      FIELD(ShellVertex, bendXZ),
          FIELD(ShellVertex, overAcross),  FIELD(ShellVertex, bendYY),
          FIELD(ShellVertex, underAcross), FIELD(ShellVertex, bendYZ),
          FIELD(ShellVertex, place),       FIELD(ShellVertex, bendZZ),
          FIELD(ShellVertex, tint),        FIELD(ShellVertex, combed),
          FIELD(ShellVertex, turn)}},
        {"ShellCorners",
         "shellCorners",
         sizeof(ShellCorner),
         {FIELD(ShellCorner, outer), FIELD(ShellCorner, top), FIELD(ShellCorner, position),
          FIELD(ShellCorner, pad0), FIELD(ShellCorner, normal), FIELD(ShellCorner, pad1)}},
        {"RestVertices",
         "restVertices",
         sizeof(RestVertex),
         {FIELD(RestVertex, position), FIELD(RestVertex, pad0), FIELD(RestVertex, turn)}},
        {"Bends",
         "bends",
         sizeof(Bend),
         {FIELD(Bend, normal), FIELD(Bend, pad0), Field{"xx", offsetof(Bend, curvature.xx)},
          Field{"xy", offsetof(Bend, curvature.xy)}, Field{"xz", offsetof(Bend, curvature.xz)},
          Field{"yy", offsetof(Bend, curvature.yy)}, Field{"yz", offsetof(Bend, curvature.yz)},
          Field{"zz", offsetof(Bend, curvature.zz)}, Field{"pad1", offsetof(Bend, curvature.pad0)},
          Field{"pad2", offsetof(Bend, curvature.pad1)}}},
    };
    for (const auto& b : blocks) expectElements(program.name(), b.block, b.array, b.size, b.fields);
    // Marching reads the rows of a vertex as texels.
    EXPECT_EQ(sizeof(ShellVertex), 11 * sizeof(vec4));

    expectUniforms(program.name(), "ShellBlock", "", sizeof(ShellData),
                   {Field{"shellOver.period", offsetof(ShellData, over.period)},
                    Field{"shellOver.width", offsetof(ShellData, over.width)},
                    Field{"shellOver.taper", offsetof(ShellData, over.taper)},
                    Field{"shellOver.stray", offsetof(ShellData, over.stray)},
                    Field{"shellUnder.period", offsetof(ShellData, under.period)},
                    Field{"shellUnder.width", offsetof(ShellData, under.width)},
                    Field{"shellUnder.taper", offsetof(ShellData, under.taper)},
                    Field{"shellUnder.stray", offsetof(ShellData, under.stray)},
                    Field{"shellLayers", offsetof(ShellData, layers)},
                    Field{"leastWidth", offsetof(ShellData, leastWidth)},
                    Field{"shellCoats", offsetof(ShellData, coats)},
                    Field{"shellPad0", offsetof(ShellData, pad0)}});
    const Program map = Program::draw("shell_layer.vert", "shell_map.frag", {"MAP"});
    expectUniforms(map.name(), "ShellMapBlock", "", sizeof(ShellMapData),
                   {Field{"mapTones", offsetof(ShellMapData, tones)},
                    Field{"mapSide", offsetof(ShellMapData, side)},
                    Field{"mapPhoto", offsetof(ShellMapData, photo)},
                    Field{"mapLayers", offsetof(ShellMapData, layers)},
                    Field{"mapPad0", offsetof(ShellMapData, pad0)},
                    Field{"mapCoverage", offsetof(ShellMapData, coverage)},
                    Field{"mapTaper", offsetof(ShellMapData, taper)},
                    Field{"mapGap", offsetof(ShellMapData, gap)}});
}

}  // namespace
}  // namespace pelage
