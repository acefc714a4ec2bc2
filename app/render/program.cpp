// program.cpp -- shader programs from the embedded files.
#include "app/render/program.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>

#include "core/embedded.h"

namespace pelage {
namespace {

std::string shaderFile(std::string_view name, std::string_view includedFrom) {
    if (const char* folder = std::getenv("PELAGE_SHADERS")) {
        std::ifstream file(std::string(folder) + "/" + std::string(name), std::ios::binary);
        if (file) return {std::istreambuf_iterator<char>(file), {}};
    }
    for (const EmbeddedFile& file : embeddedShaders())
        if (file.name == name) return std::string(file.text);
    throw std::runtime_error(std::string(includedFrom) + ": there is no shader file " +
                             std::string(name));
}

void expand(std::string_view name, std::string_view includedFrom, ShaderText& result) {
    if (std::find(result.files.begin(), result.files.end(), name) != result.files.end()) return;
    const std::string number = std::to_string(result.files.size());
    result.files.emplace_back(name);
    const std::string text = shaderFile(name, includedFrom);

    result.text += "#line 1 " + number + "\n";
    std::size_t line = 1;
    for (std::size_t at = 0; at < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view row(text.data() + at, end - at);
        constexpr std::string_view kInclude = "#include \"";
        if (row.starts_with(kInclude)) {
            expand(row.substr(kInclude.size(), row.rfind('"') - kInclude.size()), name, result);
            result.text += "#line " + std::to_string(line + 1) + " " + number;
        } else {
            result.text += row;
        }
        result.text += '\n';
        at = end + 1;
    }
}

std::string firstLine(const std::string& log) { return log.substr(0, log.find('\n')); }

// The driver's log names source numbers, "2:14(5): error: ..."; put the file's name instead. Only
// the first error: the others mostly follow from it.
std::string readableLog(const std::string& whole, const std::vector<std::string>& files) {
    const std::string log = firstLine(whole);
    const std::regex place(R"((\d+)[:(](\d+)\)?(\(\d+\))?:? *)");
    std::smatch match;
    if (!std::regex_search(log, match, place)) return files.front() + ": " + log;
    const std::size_t number = std::stoul(match[1]);
    return (number < files.size() ? files[number] : files.front()) + ": line " + match[2].str() +
           ": " + match.suffix().str();
}

GLuint compile(GLenum stage, std::string_view name, const std::vector<std::string>& defines) {
    const ShaderText shader = expandShader(name);
    std::string head = "#version 450 core\n";
    for (const std::string& define : defines) head += "#define " + define + "\n";
    const std::string text = head + shader.text;
    const char* source = text.c_str();
    const GLuint object = glCreateShader(stage);
    glShaderSource(object, 1, &source, nullptr);
    glCompileShader(object);
    GLint good = 0;
    glGetShaderiv(object, GL_COMPILE_STATUS, &good);
    if (!good) {
        char log[4096] = "";
        glGetShaderInfoLog(object, sizeof log, nullptr, log);
        glDeleteShader(object);
        throw std::runtime_error(readableLog(log, shader.files));
    }
    return object;
}

gl::ProgramName link(std::initializer_list<GLuint> shaders, std::string_view name) {
    gl::ProgramName program(glCreateProgram());
    for (const GLuint shader : shaders) glAttachShader(program.name(), shader);
    glLinkProgram(program.name());
    for (const GLuint shader : shaders) glDeleteShader(shader);
    GLint good = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (!good) {
        char log[4096] = "";
        glGetProgramInfoLog(program.name(), sizeof log, nullptr, log);
        throw std::runtime_error(std::string(name) + ": " + firstLine(log));
    }
    return program;
}

}  // namespace

ShaderText expandShader(std::string_view name) {
    ShaderText result;
    expand(name, name, result);
    return result;
}

Program Program::compute(std::string_view name, const std::vector<std::string>& defines) {
    Program program;
    program.name_ = link({compile(GL_COMPUTE_SHADER, name, defines)}, name);
    return program;
}

Program Program::draw(std::string_view vertex, std::string_view fragment,
                      const std::vector<std::string>& defines) {
    Program program;
    program.name_ = link({compile(GL_VERTEX_SHADER, vertex, defines),
                          compile(GL_FRAGMENT_SHADER, fragment, defines)},
                         fragment);
    return program;
}

}  // namespace pelage
