// check.h -- the picture of all hairs, drawn aside, that one of fewer is held against.
#pragma once

#include "app/render/canvas.h"
#include "app/render/post_pass.h"

namespace pelage {

struct Check {
    Canvas canvas;  // of the next sample
    PostPass post;
    int samples = 0;

    void resize(ivec2 size);
    void add();  // the sample
    // The mean FLIP of a picture of as many samples, neither with its lines.
    float errorOf(PostPass& picture, const Canvas& last);
};

}  // namespace pelage
