// gltf_carry.h -- the glTF of a source as a draft of the file to be written.
#pragma once

#include "glb_draft.h"
#include "gltf_carried.h"
#include "source.h"

namespace pelage {

// The carried JSON value for value, with the buffers merged into one: content and views keep their
// bytes. What the objects of the others said besides (names, extras) is kept in
// extras.mergedBuffers of the one. Throws std::runtime_error.
GlbDraft carriedDraft(const CarriedGltf& carried);

// Pictures that lay in files of their own become views. One of a type that glTF cannot name, or
// that could not be read, keeps its URI.
void embedPictures(GlbDraft& draft, const CarriedGltf& carried);

// A glTF of a source that was none: one mesh with one primitive per part. Normals are made unit,
// as glTF asks; all else is bit for bit.
GlbDraft builtDraft(const Source& source);

// Either, whichever the source is, with its pictures and without any fur fields.
GlbDraft bareDraft(const Source& source);

// "image/png", "image/jpeg", "image/webp" or "image/ktx2" by the first bytes, else "".
std::string pictureType(std::span<const std::byte> bytes);

// A PNG without the chunks that say how to show its colors and the shape of its pixels: a glTF
// reader must ignore them (glTF 2.0, section 3.8.2), and validators warn of them. Other bytes as
// they are.
std::vector<std::byte> plainPicture(std::span<const std::byte> bytes);

}  // namespace pelage
