// spacing.h -- how far the vertices that hold the fur are apart, and whether the fur notices.
#pragma once

#include <string>
#include <vector>

#include "document.h"

namespace pelage {

// Median length of the edges, m, world; of some tens of thousands of them where there are more.
float medianSpacing(const Skin& skin);

// Mean length of the edges at vertex v, m; 0 without one.
float spacingAt(const Skin& skin, uint v);

// Median length of hair, m, world, over the vertices that bear any; 0 where none does.
float medianHair(const Document& document);

// What is worth telling, one line with its numbers each: vertices that are farther apart than the
// hair is long (medians, in the world), and more than ten vertices for each hair. Usually nothing.
std::vector<std::string> spacingNotes(const Document& document);

}  // namespace pelage
