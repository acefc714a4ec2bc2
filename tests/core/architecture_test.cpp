// architecture_test.cpp -- core <- app/render <- app: who may include what.
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "gtest/gtest.h"

namespace pelage {
namespace {

namespace fs = std::filesystem;

struct Include {
    std::string file, line;
};

// The #include lines of the sources in a folder of the repository whose names end as given.
std::vector<Include> includesOf(const std::string& folder,
                                const std::vector<std::string>& endings) {
    std::vector<Include> includes;
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(PELAGE_SOURCE_DIR) / folder)) {
        const std::string path = entry.path().string();
        bool wanted = false;
        for (const std::string& ending : endings) wanted = wanted || path.ends_with(ending);
        if (!wanted) continue;
        std::ifstream file(path);
        for (std::string line; std::getline(file, line);) {
            if (line.starts_with("#include")) includes.push_back({path, line});
        }
    }
    return includes;
}

void expectNone(const std::vector<Include>& includes, const char* pattern) {
    EXPECT_GT(includes.size(), 10u) << "the sources were not found";
    const std::regex forbidden(pattern, std::regex::icase);
    for (const Include& include : includes) {
        EXPECT_FALSE(std::regex_search(include.line, forbidden))
            << include.file << ": " << include.line;
    }
}

TEST(Architecture, CoreKnowsNeitherOpenGlNorWindowsNorWidgetsNorTheApp) {
    expectNone(includesOf("core", {".h", ".cpp"}),
               R"([<"](GL/|GLES|EGL/|epoxy|GLFW|imgui|app/|CLI/))");
}

TEST(Architecture, HeadersOfCoreHideTheLibrariesBehindThem) {
    expectNone(includesOf("core", {".h"}), R"([<"](OpenMesh|tiny_gltf|embree|tbb/|oneapi))");
}

TEST(Architecture, TheRendererKnowsNeitherWindowsNorWidgets) {
    for (const char* folder : {"app/render", "app/measure"})
        expectNone(includesOf(folder, {".h", ".cpp"}), R"([<"](GLFW|imgui|CLI/))");
}

TEST(Architecture, NoRandomNumbersOfTheLibraryAndNoClockInCore) {
    expectNone(includesOf("core", {".h", ".cpp"}), R"([<"](random|chrono|ctime)[>"])");
}

}  // namespace
}  // namespace pelage
