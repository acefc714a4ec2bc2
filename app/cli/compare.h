// compare.h -- the figures of image errors as the command line gives them.
#pragma once

#include "app/cli/print.h"
#include "core/image_error.h"

namespace pelage {

// By the names of ImageErrors; coverage is null where there is none.
OrderedJson jsonOf(const ImageErrors& errors);

}  // namespace pelage
