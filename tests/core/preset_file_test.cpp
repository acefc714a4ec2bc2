// preset_file_test.cpp -- the promises of preset_file.h and swatch.h.
#include "core/preset_file.h"

#include <cmath>
#include <cstdlib>

#include "core/animal.h"
#include "core/files.h"
#include "core/script.h"
#include "core/swatch.h"
#include "gtest/gtest.h"
#include "reading.h"
#include "test_skins.h"

namespace pelage {
namespace {

using test::refusal;
using test::TempFolder;

// A variable of the environment that has another value, or none, while this lives.
class Variable {
public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        if (value)
            ::setenv(name, value, 1);
        else
            ::unsetenv(name);
    }
    ~Variable() {
        if (old_)
            ::setenv(name_, old_->c_str(), 1);
        else
            ::unsetenv(name_);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
    std::optional<std::string> old_;
};

// Every value drawn from its whole range, with all bits of its fraction in use.
Fur randomFur(uint seed) {
    test::Draws draws(seed);
    Fur fur = defaultFur();
    const auto fill = [&](auto& object, std::span<const Parameter> rows) {
        for (const Parameter& row : rows) {
            const float greatest = std::min(row.greatest, 1e6f);
            vec3 value;
            for (int i = 0; i < 3; ++i) value[i] = draws.in(row.least, greatest) / 1.0000001f;
            setParameter(object, row, value);
        }
    };
    fill(fur, furParameters());
    fill(fur.over, coatParameters());
    fill(fur.under, coatParameters());
    return fur;
}

std::vector<std::byte> smallPicture() {
    return test::bytesOf(std::string_view("\x89PNG\r\n\x1A\n\0\1\2\xFF", 12));
}

Preset wolf() {
    return {"my \"wolf\" \xC3\xBC", "Ann", "Grey.", randomFur(3), true, smallPicture(), ""};
}

TEST(PresetFile, SurvivesARoundTripBitForBit) {
    for (uint seed = 1; seed <= 20; ++seed) {
        Preset preset = wolf();
        preset.fur = randomFur(seed);
        preset.thumbnail.resize(8 + seed % 5, std::byte(seed));
        const Preset read = presetFromText(presetText(preset), "wolf.fur.json");
        EXPECT_EQ(read.name, preset.name);
        EXPECT_EQ(read.author, preset.author);
        EXPECT_EQ(read.note, preset.note);
        EXPECT_EQ(read.fur, preset.fur) << "seed " << seed;
        EXPECT_TRUE(read.seeded);
        EXPECT_EQ(read.thumbnail, preset.thumbnail);
        EXPECT_EQ(read.file, "wolf.fur.json");
    }
}

TEST(PresetFile, WithASeedOfItsOwnBringsItAndWithoutLeavesTheOld) {
    Preset preset = wolf();
    preset.fur.seed = 5;
    for (const bool seeded : {true, false}) {
        preset.seeded = seeded;
        const Preset read = presetFromText(presetText(preset), "wolf.fur.json");
        EXPECT_EQ(read.seeded, seeded);
        Fur fur = defaultFur();
        fur.seed = 77;
        applyPreset(fur, read);
        EXPECT_EQ(fur.seed, seeded ? 5u : 77u);
        EXPECT_EQ(fur.over, preset.fur.over);
    }
}

TEST(PresetFile, WhatIsMissingHasItsDefaultAndUnknownNamesAreIgnored) {
    const Preset read = presetFromText(
        R"({"fur": {"over": {"stiffness": 0.25, "warmth": 3}, "magic": []}, "mood": {"a": 1}})",
        "coats/grey wolf.fur.json");
    Fur wanted = defaultFur();
    wanted.over.stiffness = 0.25f;
    EXPECT_EQ(read.fur, wanted);
    EXPECT_EQ(read.name, "grey wolf");
    EXPECT_EQ(read.author + read.note, "");
    EXPECT_TRUE(read.thumbnail.empty());
    EXPECT_FALSE(read.seeded);
}

TEST(PresetFile, BadOnesAreRefusedByFilePlaceAndNumbers) {
    const struct {
        const char *text, *message;
    } cases[] = {
        {R"({"fur": {"over": {"stiffness": 3}}})",
         "w.fur.json: fur: over.stiffness is 3, range 0..1"},
        {R"({"fur": {"hairs": "many"}})",
         "w.fur.json: fur: hairs is not a whole number, range 0..5000000"},
        {R"({"fur": {"version": 2}})", "w.fur.json: fur: version is 2, this program reads 1..1"},
        {R"({"fur": []})", "w.fur.json: fur: is an array, not an object"},
        {R"({"version": 2, "fur": {}})",
         "w.fur.json: version: is 2, not a whole number from 1 to 1"},
        {R"({"name": "wolf"})", "w.fur.json: has no \"fur\", so it is no preset"},
        {R"(["fur"])", "w.fur.json: has no \"fur\", so it is no preset"},
        {R"({"name": 7, "fur": {}})", "w.fur.json: name: is 7, not a string"},
        {R"({"note": "two\nlines", "fur": {}})", "w.fur.json: note: holds a control code"},
        {R"({"fur": {}, "thumbnail": "wolf.png"})",
         "w.fur.json: thumbnail: its data URI is not in base64"},
        {R"({"fur": {}, "thumbnail": "data:image/png;base64,AAAA"})",
         "w.fur.json: thumbnail: is neither a PNG nor a JPEG"},
        {R"({"fur": )", "w.fur.json: JSON is broken or cut off at byte 9 of 8"},
    };
    for (const auto& [text, message] : cases)
        EXPECT_EQ(refusal([&, t = text] { presetFromText(t, "w.fur.json"); }), message) << text;
    const std::string deep(5000, '[');
    EXPECT_NE(refusal([&] { presetFromText("{\"fur\":" + deep, "w.fur.json"); }).find("nested"),
              std::string::npos);
}

TEST(PresetFile, TextsAndFilesHaveABound) {
    const struct {
        const char* member;
        std::size_t most;
    } rows[] = {{"name", 60}, {"author", 100}, {"note", 1000}};
    for (const auto& [member, most] : rows) {
        const auto text = [name = std::string(member)](std::size_t bytes) {
            return "{\"" + name + "\": \"" + std::string(bytes, 'x') + "\", \"fur\": {}}";
        };
        EXPECT_EQ(refusal([&, m = most] { presetFromText(text(m), "w"); }), "(not refused)");
        EXPECT_EQ(refusal([&, m = most] { presetFromText(text(m + 1), "w"); }),
                  "w: " + std::string(member) + ": is " + std::to_string(most + 1) +
                      " bytes long, at most " + std::to_string(most));
    }
    const TempFolder folder;
    const std::string large = folder.write("large.fur.json", std::string((1 << 18) + 1, ' '));
    EXPECT_EQ(refusal([&] { readPreset(large); }),
              large + ": is 262145 bytes long; at most 262144 are read");
}

TEST(PresetFile, IsWrittenUnderItsExtensionAndOnlyIfItCanBeRead) {
    const TempFolder folder;
    const std::string path = folder.path("wolf.fur.json");
    writePreset(wolf(), path);
    EXPECT_EQ(readPreset(path).fur, wolf().fur);
    EXPECT_EQ(refusal([&] { writePreset(wolf(), folder.path("wolf.json")); }),
              "\"" + folder.path("wolf.json") + "\" does not end in .fur.json");
    Preset bad = wolf();
    bad.note = "two\nlines";
    EXPECT_EQ(refusal([&] { writePreset(bad, path); }), path + ": note: holds a control code");
    EXPECT_EQ(readPreset(path).note, wolf().note);  // the old one stays
    EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(OwnPresets, ComeInTheOrderOfTheirNamesAndBadOnesAreTold) {
    const TempFolder folder;
    for (const char* name : {"b", "a", "c"}) {
        Preset preset = wolf();
        preset.name = name;
        writePreset(preset, folder.path(std::string("file") + name + ".fur.json"));
    }
    folder.write("bad.fur.json", "{");
    folder.write("other.json", "{");
    const OwnPresets own = ownPresets(folder.path());
    ASSERT_EQ(own.presets.size(), 3u);
    EXPECT_EQ(own.presets[0].name, "a");
    EXPECT_EQ(own.presets[2].name, "c");
    EXPECT_EQ(own.presets[2].file, folder.path("filec.fur.json"));
    ASSERT_EQ(own.warnings.size(), 1u);
    EXPECT_EQ(own.warnings[0].find(folder.path("bad.fur.json") + ": "), 0u) << own.warnings[0];
    EXPECT_TRUE(ownPresets(folder.path("absent")).presets.empty());
    EXPECT_TRUE(ownPresets("").warnings.empty());
}

TEST(OwnPresets, AFileForANewOneReplacesOnlyItsOwnName) {
    const TempFolder folder;
    Preset preset = wolf();
    preset.name = "grey wolf";
    const auto path = [&](const std::string& name) {
        return presetPath(folder.path(), ownPresets(folder.path()), name);
    };
    EXPECT_EQ(path("grey wolf"), folder.path("grey_wolf.fur.json"));
    writePreset(preset, folder.path("elsewhere.fur.json"));
    EXPECT_EQ(path("grey wolf"), folder.path("elsewhere.fur.json"));
    folder.write("grey_wolf.fur.json", "{");
    EXPECT_EQ(path("grey/wolf"), folder.path("grey_wolf_2.fur.json"));
    EXPECT_EQ(refusal([&] { path("mink"); }), "\"mink\" is a preset of the program");
    EXPECT_EQ(refusal([&] { presetPath("", {}, "x"); }),
              "no place for presets: HOME names no folder");
}

TEST(OwnPresets, TheFolderFollowsTheEnvironment) {
    const Variable data("XDG_DATA_HOME", "/data");
    EXPECT_EQ(presetFolder(), "/data/pelage/presets");
    const Variable relative("XDG_DATA_HOME", "data");
    const Variable home("HOME", "/home/ann");
    EXPECT_EQ(presetFolder(), "/home/ann/.local/share/pelage/presets");
    const Variable none("HOME", nullptr);
    EXPECT_EQ(presetFolder(), "");
}

TEST(FindPreset, TakesAFileOrTheProgramsOrTheUsersOwn) {
    const TempFolder folder;
    const Variable data("XDG_DATA_HOME", folder.path().c_str());
    std::filesystem::create_directories(presetFolder());
    Preset mine = wolf();
    mine.name = "grey";
    writePreset(mine, presetFolder() + "/x.fur.json");
    Preset fake = wolf();
    fake.name = "mink";
    writePreset(fake, presetFolder() + "/y.fur.json");
    EXPECT_EQ(findPreset("grey").fur, mine.fur);
    EXPECT_EQ(findPreset("mink").fur, presetNamed("mink").fur) << "the program's comes first";
    EXPECT_EQ(findPreset(presetFolder() + "/y.fur.json").fur, fake.fur);
    const std::string text = refusal([] { findPreset("poodle"); });
    EXPECT_NE(text.find("mink"), std::string::npos) << text;
    EXPECT_NE(text.find("grey"), std::string::npos) << text;
}

TEST(FindPreset, ALineOfScriptPutsAFileOnAsOneStep) {
    const TempFolder folder;
    const std::string path = folder.path("my wolf.fur.json");
    writePreset(wolf(), path);
    Workspace workspace, other;
    workspace.open(test::evenDocument(test::ball(2)));
    other.open(test::evenDocument(test::ball(2)));
    const Fur before = workspace.editor->document().fur;
    runLine(workspace, "preset " + path);
    const Fur after = workspace.editor->document().fur;
    EXPECT_EQ(after, wolf().fur);
    EXPECT_EQ(workspace.editor->stepCount(), 2u);
    // What the window's journal holds does not need the file.
    runLine(other, setLine(before, after));
    EXPECT_EQ(other.editor->document().fur, after);
    runLine(workspace, "undo");
    EXPECT_EQ(workspace.editor->document().fur, before);
}

TEST(Swatch, IsAClosedBallAsDenseAsTheAnimal) {
    const Document ball = swatch(presetNamed("mink").fur);
    const Skin& skin = *ball.skin;
    EXPECT_TRUE(skin.outward);
    EXPECT_EQ(skin.report.boundaryEdges, 0u);
    EXPECT_EQ(skin.report.degenerateFaces, 0u);
    EXPECT_NEAR(skin.radius, 0.13f, 1e-3f);
    const double animal = makeSkin(makeAnimal(20000))->area;
    const double hairs = presetNamed("mink").fur.hairs;
    EXPECT_NEAR(ball.fur.hairs / skin.area, hairs / animal, 0.05 * hairs / animal);
    EXPECT_EQ(fieldRange(ball.groom, Channel::length).least, 0.045f);
}

}  // namespace
}  // namespace pelage
