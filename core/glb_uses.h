// glb_uses.h -- what of a draft is named by what, and how accessors are replaced in it.
#pragma once

#include <set>

#include "glb_draft.h"

namespace pelage {

// Accessors and buffer views as often as core glTF names them.
std::multiset<std::size_t> accessorUses(const OrderedJson& gltf);
std::multiset<std::size_t> viewUses(const OrderedJson& gltf);

// Gives what names an accessor another one. Numbers and names stay, and with them what extensions
// may say about them, as far as nothing else uses the old values.
class AccessorReplacer {
public:
    explicit AccessorReplacer(GlbDraft& draft);

    // The accessor that was appended last, with its view, instead of one use of `old`; returns the
    // number that it has now: `old` if that was its last use.
    std::size_t replace(std::size_t old);

private:
    void release(const OrderedJson& accessor);

    GlbDraft& draft_;
    std::multiset<std::size_t> accessors_, views_;
};

// Takes out the bytes that no view covers. Does nothing in a file with extensions of views, which
// may know of others.
void dropUnusedBytes(GlbDraft& draft);

}  // namespace pelage
