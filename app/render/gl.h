// gl.h -- OpenGL objects as move-only values (OpenGL 4.5, direct state access).
#pragma once

#include <epoxy/gl.h>

#include <cassert>
#include <cstddef>
#include <span>
#include <utility>

#include "core/types.h"

namespace pelage::gl {

// A name that is deleted with its owner. Empty until assigned, so that members can exist before
// the context does.
template <typename Kind>
class Object {
public:
    Object() = default;
    explicit Object(GLuint name) : name_(name) {}
    Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Object() {
        if (name_) Kind::remove(name_);
    }
    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

private:
    GLuint name_ = 0;
};

struct BufferKind {
    static void remove(GLuint name) { glDeleteBuffers(1, &name); }
};
struct TextureKind {
    static void remove(GLuint name) { glDeleteTextures(1, &name); }
};
struct FramebufferKind {
    static void remove(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct VertexArrayKind {
    static void remove(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct ProgramKind {
    static void remove(GLuint name) { glDeleteProgram(name); }
};
struct QueryKind {
    static void remove(GLuint name) { glDeleteQueries(1, &name); }
};

using Query = Object<QueryKind>;
using Texture = Object<TextureKind>;
using Framebuffer = Object<FramebufferKind>;
using VertexArray = Object<VertexArrayKind>;
using ProgramName = Object<ProgramKind>;

// A buffer that knows its size in bytes. Never smaller than 16 bytes: an empty binding is an error.
class Buffer {
public:
    Buffer() = default;

    // New storage when the size differs, then the content.
    template <typename T>
    void upload(std::span<const T> values) {
        resize(values.size_bytes());
        write(0, values);
    }
    template <typename T>
    void write(std::size_t offset, std::span<const T> values) {
        assert(offset + values.size_bytes() <= bytes_);
        if (!values.empty())
            glNamedBufferSubData(object_.name(), static_cast<GLintptr>(offset),
                                 static_cast<GLsizeiptr>(values.size_bytes()), values.data());
    }
    // Content is undefined where the size changed.
    void resize(std::size_t bytes) {
        bytes = bytes < 16 ? 16 : bytes;
        if (bytes == bytes_) return;
        GLuint name = 0;
        glCreateBuffers(1, &name);
        object_ = Object<BufferKind>(name);
        glNamedBufferStorage(name, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_STORAGE_BIT);
        bytes_ = bytes;
    }
    void bindStorage(GLuint binding) const {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, object_.name());
    }
    void bindUniform(GLuint binding) const {
        glBindBufferBase(GL_UNIFORM_BUFFER, binding, object_.name());
    }
    GLuint name() const { return object_.name(); }
    std::size_t bytes() const { return bytes_; }

private:
    Object<BufferKind> object_;
    std::size_t bytes_ = 0;
};

inline Texture makeTexture(ivec2 size, GLenum format, GLsizei levels = 1) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, levels, format, size.x, size.y);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER,
                        levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, levels > 1 ? GL_LINEAR : GL_NEAREST);
    return Texture(name);
}

// The same memory, to be read as texels. To be made anew where the buffer is another one.
inline Texture makeTexture(const Buffer& buffer, GLenum format) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &name);
    glTextureBuffer(name, format, buffer.name());
    return Texture(name);
}

// So many groups or a few more, of the compute shader in use, in as many rows as they need.
inline void dispatch(std::size_t groups) {
    constexpr std::size_t kMost = 65535;  // least value of GL_MAX_COMPUTE_WORK_GROUP_COUNT
    const std::size_t wide = groups < kMost ? groups : kMost;
    if (groups > 0)
        glDispatchCompute(static_cast<GLuint>(wide),
                          static_cast<GLuint>((groups + wide - 1) / wide), 1);
}

inline Framebuffer makeFramebuffer(const Texture& color, const Texture* depth = nullptr) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, color.name(), 0);
    if (depth) glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth->name(), 0);
    return Framebuffer(name);
}

inline Query makeQuery(GLenum target) {
    GLuint name = 0;
    glCreateQueries(target, 1, &name);
    return Query(name);
}

inline VertexArray makeVertexArray() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return VertexArray(name);
}

}  // namespace pelage::gl
