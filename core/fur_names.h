// fur_names.h -- the names of the accessors that an export adds; by them a later one finds its own.
#pragma once

namespace pelage {

inline constexpr const char* kLengthName = "fur length";
inline constexpr const char* kDensityName = "fur density";
inline constexpr const char* kDirectionName = "fur direction";
inline constexpr const char* kTintName = "fur tint";
inline constexpr const char* kSegmentName = "fur segment";
inline constexpr const char* kMirrorNames[] = {
    "fur mirror: length, density", "fur mirror: direction x, y", "fur mirror: direction z, 0"};
inline constexpr const char* kZeroName = "fur mirror: unused set";

}  // namespace pelage
