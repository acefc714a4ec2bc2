// unset.h -- an array that is not filled with zeros first: its pages are then touched by the thread
// that writes them.
#pragma once

#include <memory>
#include <vector>

namespace pelage {

template <class T>
struct UnsetAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UnsetAllocator<U>;
    };
    template <class U>
    void construct(U* place) {
        ::new (static_cast<void*>(place)) U;
    }
};

// What resize() adds has no value until it is written.
template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace pelage
