// program_gltest.cpp -- shader errors name the file and the line.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/embedded.h"
#include "tests/gl/gl_context.h"

namespace pelage {
namespace {

// A folder of shaders that the program reads instead of its own, while it lives.
class ShaderFolder {
public:
    ShaderFolder() : path_(testing::TempDir() + "pelage_shaders_" + std::to_string(getpid())) {
        std::filesystem::create_directories(path_);
        setenv("PELAGE_SHADERS", path_.c_str(), 1);
    }
    ~ShaderFolder() {
        unsetenv("PELAGE_SHADERS");
        std::filesystem::remove_all(path_);
    }
    ShaderFolder(const ShaderFolder&) = delete;
    ShaderFolder& operator=(const ShaderFolder&) = delete;

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ + "/" + name) << text;
    }

private:
    std::string path_;
};

std::string messageOf(const std::string& shader) {
    try {
        Program::compute(shader);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

void expectStartsWith(const std::string& text, const std::string& start) {
    EXPECT_EQ(text.substr(0, start.size()), start) << text;
    EXPECT_GT(text.size(), start.size()) << "no message after the place";
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

TEST(Program, ABrokenShaderGivesFileAndLine) {
    const ShaderFolder folder;
    folder.write("broken.comp",
                 "layout(local_size_x = 1) in;\nvoid main() {\n    nonsense();\n}\n");
    expectStartsWith(messageOf("broken.comp"), "broken.comp: line 3: ");
}

TEST(Program, ABrokenIncludeGivesItsOwnFileAndLine) {
    const ShaderFolder folder;
    // Not an unknown name: Mesa 22 says of those that they are in the first file.
    folder.write("inner.glsl", "// comment\n\nfloat f() { return vec2(1.0); }\n");
    folder.write("outer.comp",
                 "#include \"inner.glsl\"\nlayout(local_size_x = 1) in;\nvoid main() {}\n");
    expectStartsWith(messageOf("outer.comp"), "inner.glsl: line 3: ");
    // After an include, lines count on in the file that includes.
    folder.write("inner.glsl", "float f() { return 1.0; }\n");
    folder.write(
        "outer.comp",
        "#include \"inner.glsl\"\nlayout(local_size_x = 1) in;\nvoid main() { nonsense(); }\n");
    expectStartsWith(messageOf("outer.comp"), "outer.comp: line 3: ");
}

TEST(Program, AnUnknownIncludeNamesTheIncluder) {
    const ShaderFolder folder;
    folder.write("outer.comp", "#include \"nowhere.glsl\"\nvoid main() {}\n");
    EXPECT_EQ(messageOf("outer.comp"), "outer.comp: there is no shader file nowhere.glsl");
    folder.write("outer.comp", "#include \"inner.glsl\"\nvoid main() {}\n");
    folder.write("inner.glsl", "#include \"nowhere.glsl\"\n");
    EXPECT_EQ(messageOf("outer.comp"), "inner.glsl: there is no shader file nowhere.glsl");
}

TEST(Program, EachFileIsIncludedOnce) {
    const ShaderFolder folder;
    folder.write("a.glsl", "#include \"b.glsl\"\nfloat a() { return b(); }\n");
    folder.write("b.glsl", "#include \"a.glsl\"\nfloat b() { return 1.0; }\n");
    folder.write("c.comp",
                 "#include \"a.glsl\"\n#include \"b.glsl\"\nlayout(local_size_x = 1) in;\n"
                 "void main() { a(); }\n");
    EXPECT_EQ(messageOf("c.comp"), "");
    EXPECT_EQ(expandShader("c.comp").files,
              (std::vector<std::string>{"c.comp", "a.glsl", "b.glsl"}));
}

TEST(Program, DefinesReachTheShader) {
    const ShaderFolder folder;
    folder.write(
        "defined.comp",
        "layout(local_size_x = 1) in;\n#ifndef WANTED\nnonsense\n#endif\nvoid main() {}\n");
    EXPECT_NO_THROW(Program::compute("defined.comp", {"WANTED"}));
    EXPECT_NE(messageOf("defined.comp"), "");
}

TEST(Program, FilesOutsideTheFolderAreTheEmbeddedOnes) {
    const ShaderFolder folder;
    EXPECT_NO_THROW(Program::compute("strand_raster.comp"));
    EXPECT_EQ(messageOf("nowhere.comp"), "nowhere.comp: there is no shader file nowhere.comp");
}

}  // namespace
}  // namespace pelage
