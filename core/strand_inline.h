// strand_inline.h -- the shared source of hairs as functions of the file that includes this.
//
// For loops that strand.h would slow down: the compiler inlines what is called and leaves out what
// is not. Not together with strand.h, whose functions have the same names.
#pragma once

#include "elastica.h"  // the table that the source asks for
#include "types.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
namespace pelage {
namespace {
#include "strand_source.h"
}  // namespace
}  // namespace pelage
#pragma GCC diagnostic pop
