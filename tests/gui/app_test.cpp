// app_test.cpp -- the parts of the editor that need no window: settings, jobs, brush habits.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "app/export_check.h"
#include "app/session.h"
#include "app/settings.h"
#include "app/work.h"
#include "core/animal.h"
#include "core/gltf_out.h"

namespace pelage {
namespace {

namespace fs = std::filesystem;

struct Folder {
    fs::path path = fs::temp_directory_path() /
                    ("pelage-app-test-" +
                     std::to_string(std::hash<std::thread::id>()(std::this_thread::get_id())));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    std::string file(const std::string& name) const { return (path / name).string(); }
};

void await(Work& work) {
    while (work.running()) {
        work.collect();
        std::this_thread::yield();
    }
}

TEST(Settings, SurviveARoundTrip) {
    const Folder folder;
    Settings settings;
    settings.scale = 1.5f;
    settings.folder = "/somewhere";
    remember(settings, "/a/b.glb");
    saveSettings(settings, folder.file("deep/settings.json"));
    const LoadedSettings loaded = loadSettings(folder.file("deep/settings.json"));
    EXPECT_EQ(loaded.warning, "");
    EXPECT_EQ(loaded.settings.scale, 1.5f);
    EXPECT_EQ(loaded.settings.folder, "/somewhere");
    EXPECT_EQ(loaded.settings.recent, settings.recent);
}

TEST(Settings, DamagedFileGivesDefaultsAndSaysSo) {
    const Folder folder;
    std::ofstream(folder.file("settings.json")) << "{\"recent\": 7";
    const LoadedSettings loaded = loadSettings(folder.file("settings.json"));
    EXPECT_NE(loaded.warning.find("settings.json"), std::string::npos);
    EXPECT_TRUE(loaded.settings.recent.empty());
    EXPECT_EQ(loadSettings(folder.file("absent.json")).warning, "");
}

TEST(Settings, LatestFileComesFirstAndOnce) {
    Settings settings;
    for (int i = 0; i < 20; ++i) remember(settings, "/f" + std::to_string(i));
    remember(settings, "/f15");
    ASSERT_EQ(settings.recent.size(), 12u);
    EXPECT_EQ(settings.recent[0], "/f15");
    EXPECT_EQ(settings.recent[1], "/f19");
    EXPECT_EQ(std::count(settings.recent.begin(), settings.recent.end(), "/f15"), 1);
}

TEST(Work, ResultIsCarriedOutOnTheMainThread) {
    Work work;
    std::thread::id worker, finisher;
    work.start(
        "job",
        [&](Progress&) -> Finish {
            worker = std::this_thread::get_id();
            return [&] { finisher = std::this_thread::get_id(); };
        },
        [](const std::string& problem) { FAIL() << problem; }, [] {});
    await(work);
    EXPECT_EQ(finisher, std::this_thread::get_id());
    EXPECT_NE(worker, finisher);
}

TEST(Work, CapturesDieOnTheMainThread) {
    Work work;
    std::thread::id died;
    std::shared_ptr<int> captured(new int(1), [&](const int* number) {
        died = std::this_thread::get_id();
        delete number;
    });
    work.start(
        "job", [held = std::move(captured)](Progress&) -> Finish { return [] {}; },
        [](const std::string& problem) { FAIL() << problem; }, [] {});
    await(work);
    EXPECT_EQ(died, std::this_thread::get_id());
}

TEST(Work, CancelledJobIsToldAsSuch) {
    Work work;
    std::string told;
    work.start(
        "job",
        [](Progress& progress) -> Finish {
            for (;;) progress.report(0.5f);
        },
        [&](const std::string& problem) { told = problem; }, [] {});
    work.cancel();
    await(work);
    EXPECT_EQ(told, "cancelled");
}

TEST(Work, FinishMayStartTheNextJob) {
    Work work;
    int jobs = 0;
    const auto fail = [](const std::string& problem) { FAIL() << problem; };
    work.start(
        "first",
        [&](Progress&) -> Finish {
            return [&] {
                ++jobs;
                work.start(
                    "second", [&](Progress&) -> Finish { return [&] { ++jobs; }; }, fail, [] {});
            };
        },
        fail, [] {});
    await(work);
    EXPECT_EQ(jobs, 2);
}

TEST(Session, ControlExchangesAddAndSubtractAndShiftSmooths) {
    Session session;
    for (const ToolInfo& info : tools())
        session.brushes[static_cast<std::size_t>(info.tool)].tool = info.tool;
    session.tool = Tool::length;
    EXPECT_EQ(heldBrush(session, false, false).mode, Mode::add);
    EXPECT_EQ(heldBrush(session, false, true).mode, Mode::subtract);
    session.brush().mode = Mode::subtract;
    EXPECT_EQ(heldBrush(session, false, true).mode, Mode::add);
    session.brush().mode = Mode::set;
    EXPECT_EQ(heldBrush(session, false, true).mode, Mode::set);
    EXPECT_EQ(heldBrush(session, true, false).tool, Tool::smooth);
}

TEST(Session, LengthsAreReadInAUnitThatSuitsThem) {
    EXPECT_EQ(lengthText(2.5f), "2.5 m");
    EXPECT_EQ(lengthText(0.031f), "3.1 cm");
    EXPECT_EQ(lengthText(0.0004f), "0.4 mm");
}

TEST(ExportCheck, ProvesAGoodFileAndNamesTheFirstDifference) {
    const Folder folder;
    Document animal = groomedAnimal(2000);
    const std::string path = folder.file("animal.glb");
    writeGroomedGlb(animal, path);
    EXPECT_NE(checkExport(animal, path, nullptr).find("equal to the bit"), std::string::npos);
    animal.groom.fur.edit(3).density = 0.123f;
    try {
        checkExport(animal, path, nullptr);
        FAIL() << "the difference was not found";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("vertex 3"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace pelage
