// program.h -- shader programs: #include, #define, errors with file and line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/render/gl.h"

namespace pelage {

// The text of an embedded shader with every `#include "x.glsl"` replaced, each file once, with
// #line directives whose source number indexes `files`. If the environment names a folder in
// PELAGE_SHADERS, files are read from there, so that a developer sees a change without building.
// Throws std::runtime_error naming the file that includes what does not exist.
struct ShaderText {
    std::string text;
    std::vector<std::string> files;
};
ShaderText expandShader(std::string_view name);

class Program {
public:
    Program() = default;
    // One compute shader, or a vertex and a fragment shader; each name in `defines` is #defined.
    // Throws std::runtime_error "shader.comp: line 12: message".
    static Program compute(std::string_view name, const std::vector<std::string>& defines = {});
    static Program draw(std::string_view vertex, std::string_view fragment,
                        const std::vector<std::string>& defines = {});

    void use() const { glUseProgram(name_.name()); }
    GLuint name() const { return name_.name(); }

private:
    gl::ProgramName name_;
};

}  // namespace pelage
