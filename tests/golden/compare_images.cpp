// compare_images.cpp -- is a picture the accepted one? Prints what it measured, either way.
//
// compare_images ACCEPTED NEW MEAN BOX COVERAGE DIFF.png: mean of the differences of all channels;
// largest difference of the means of 4x4 pixels; difference of the share of pixels that are not
// background (the color of the top left pixel). Exit status 0 when all are within tolerance;
// otherwise 1, and DIFF.png shows where, 8 times as strong.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace {

constexpr int kChannels = 3;
constexpr int kBox = 4;  // pixels on a side

struct Image {
    int width = 0, height = 0;
    std::vector<unsigned char> bytes;

    int at(int x, int y, int channel) const {
        return bytes[static_cast<std::size_t>((y * width + x) * kChannels + channel)];
    }
};

Image readImage(const char* path) {
    Image image;
    int channels = 0;
    unsigned char* bytes = stbi_load(path, &image.width, &image.height, &channels, kChannels);
    if (!bytes) throw std::runtime_error(std::string(path) + ": " + stbi_failure_reason());
    image.bytes.assign(bytes, bytes + image.width * image.height * kChannels);
    stbi_image_free(bytes);
    return image;
}

double meanDifference(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i) sum += std::abs(a.bytes[i] - b.bytes[i]);
    return sum / static_cast<double>(a.bytes.size());
}

// A box that hangs over the edge counts the pixels that are there.
double boxDifference(const Image& a, const Image& b, int left, int top, int channel) {
    double sum = 0.0;
    int pixels = 0;
    for (int y = top; y < std::min(top + kBox, a.height); ++y) {
        for (int x = left; x < std::min(left + kBox, a.width); ++x, ++pixels) {
            sum += a.at(x, y, channel) - b.at(x, y, channel);
        }
    }
    return std::abs(sum) / pixels;
}

double largestBoxDifference(const Image& a, const Image& b) {
    double largest = 0.0;
    for (int y = 0; y < a.height; y += kBox) {
        for (int x = 0; x < a.width; x += kBox) {
            for (int channel = 0; channel < kChannels; ++channel) {
                largest = std::max(largest, boxDifference(a, b, x, y, channel));
            }
        }
    }
    return largest;
}

double coverage(const Image& image) {
    int covered = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            int difference = 0;
            for (int c = 0; c < kChannels; ++c) {
                difference = std::max(difference, std::abs(image.at(x, y, c) - image.at(0, 0, c)));
            }
            covered += difference > 4;
        }
    }
    return static_cast<double>(covered) / (image.width * image.height);
}

void writeDifference(const char* path, const Image& a, const Image& b) {
    std::vector<unsigned char> bytes(a.bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<unsigned char>(std::min(255, 8 * std::abs(a.bytes[i] - b.bytes[i])));
    }
    if (!stbi_write_png(path, a.width, a.height, kChannels, bytes.data(), 0)) {
        throw std::runtime_error(std::string(path) + ": cannot be written");
    }
}

// One line of the report; true when the value is within its tolerance.
bool report(const char* what, double value, const char* tolerance) {
    const bool within = value <= std::atof(tolerance);
    std::printf("%-16s %10.5f  tolerance %s%s\n", what, value, tolerance, within ? "" : "  FAILED");
    return within;
}

int compare(char** arguments) {
    const Image accepted = readImage(arguments[1]), made = readImage(arguments[2]);
    if (accepted.width != made.width || accepted.height != made.height) {
        throw std::runtime_error(std::string(arguments[2]) + ": " + std::to_string(made.width) +
                                 "x" + std::to_string(made.height) + " pixels, expected " +
                                 std::to_string(accepted.width) + "x" +
                                 std::to_string(accepted.height));
    }
    bool same = report("mean", meanDifference(accepted, made), arguments[3]);
    same = report("largest 4x4", largestBoxDifference(accepted, made), arguments[4]) && same;
    const double coverages[] = {coverage(accepted), coverage(made)};
    std::printf("%-16s %10.5f\n", "coverage", coverages[1]);
    same = report("its difference", std::abs(coverages[0] - coverages[1]), arguments[5]) && same;
    if (!same) writeDifference(arguments[6], accepted, made);
    return same ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 7) {
        std::fprintf(stderr, "usage: compare_images ACCEPTED NEW MEAN BOX COVERAGE DIFF.png\n");
        return 2;
    }
    try {
        return compare(arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "compare_images: %s\n", error.what());
        return 1;
    }
}
