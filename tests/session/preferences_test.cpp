// Preferences survive between runs, and never keep the program from starting.
#include "editor/session/preferences.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "tests/session/test_scene.h"

namespace relievo::preferences_test {
namespace {

namespace fs = std::filesystem;

class PreferencesFile : public testing::Test {
  protected:
    PreferencesFile() { setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1); }
    ~PreferencesFile() override { unsetenv("XDG_CONFIG_HOME"); }

    static void write(const std::string& text) {
        fs::create_directories(preferences_file().parent_path());
        test::write_text(preferences_file(), text);
    }

    test::TemporaryFolder folder_;
};

TEST_F(PreferencesFile, NoneIsAllDefaultsWithoutAWarning) {
    std::string warning = "old";
    EXPECT_EQ(load_preferences(&warning), Preferences{});
    EXPECT_EQ(warning, "");
}

TEST_F(PreferencesFile, WhatIsChangedIsThereAtTheNextStart) {
    Preferences wanted;
    change_preferences([&](Preferences& p) {
        p.window_width = 2560;
        p.window_height = 1440;
        p.interface_scale = 1.75;
        p.side_width = 333.5;
        p.first_hint_seen = true;
        add_recent(p, "/scenes/a b.json");
        p.cameras[camera_key("/scenes/a b.json", 2)] = {1, 2, 3, 0.1, 0, 0, 0, 1, 0, 40};
        wanted = p;
    });
    EXPECT_EQ(load_preferences(), wanted);
}

TEST_F(PreferencesFile, RecentScenesAreShortAndWithoutRepeats) {
    Preferences p;
    for (int i = 0; i < 40; ++i) add_recent(p, "/s/" + std::to_string(i) + ".json");
    add_recent(p, "/s/../s/30.json");
    EXPECT_EQ(p.recent.size(), Preferences::kMostRecent);
    EXPECT_EQ(p.recent[0], "/s/30.json");
    EXPECT_EQ(p.recent[1], "/s/39.json");
}

TEST_F(PreferencesFile, AWrongValueIsNamedAndTheOthersCount) {
    write(R"({"window_width": "wide", "window_height": 700, "recent": 3, "first_hint_seen": true})");
    std::string warning;
    const Preferences p = load_preferences(&warning);
    EXPECT_EQ(p.window_width, 0);
    EXPECT_EQ(p.window_height, 700);
    EXPECT_TRUE(p.first_hint_seen);
    EXPECT_NE(warning.find("preferences.json: recent: must be a list of paths"), std::string::npos)
        << warning;
}

TEST_F(PreferencesFile, CamerasOfAnotherLengthAreLeftOut) {
    write(R"({"cameras": {"1 /a.json": [1, 2], "2 /a.json": [1, 2, 3, 0, 0, 0, 0, 1, 0, 40], "3 /a.json": "x"}})");
    std::string warning;
    const Preferences p = load_preferences(&warning);
    EXPECT_EQ(p.cameras.size(), 1u);
    EXPECT_TRUE(p.cameras.contains("2 /a.json"));
    EXPECT_NE(warning.find("cameras"), std::string::npos) << warning;
}

TEST_F(PreferencesFile, WildNumbersAreRefused) {
    write(R"({"window_width": 1e300, "interface_scale": -3, "side_width": 1e9})");
    EXPECT_EQ(load_preferences(), Preferences{});
}

TEST_F(PreferencesFile, ADamagedFileIsKeptBesideTheNewOne) {
    write("{\"recent\": [");
    std::string warning;
    EXPECT_EQ(load_preferences(&warning), Preferences{});
    EXPECT_NE(warning.find("not a JSON object"), std::string::npos) << warning;
    change_preferences([](Preferences& p) { p.window_width = 900; });
    EXPECT_EQ(load_preferences().window_width, 900);
    EXPECT_EQ(test::read_text(preferences_file().string() + ".damaged"), "{\"recent\": [");
}

TEST_F(PreferencesFile, KeysOfALaterVersionAreKept) {
    write(R"({"pen": {"curve": [0, 1]}, "window_width": 800})");
    change_preferences([](Preferences& p) { p.window_width = 900; });
    EXPECT_NE(test::read_text(preferences_file()).find("\"curve\""), std::string::npos);
}

TEST_F(PreferencesFile, TwoProgramsAtOnceLoseNothing) {
    std::vector<std::thread> programs;
    for (int i = 0; i < 4; ++i)
        programs.emplace_back([i] {
            change_preferences([&](Preferences& p) { add_recent(p, "/s/" + std::to_string(i) + ".json"); });
        });
    for (std::thread& program : programs) program.join();
    EXPECT_EQ(load_preferences().recent.size(), 4u);
}

TEST_F(PreferencesFile, AFolderInTheWayIsOneClearError) {
    fs::create_directories(preferences_file());
    EXPECT_THROW(change_preferences([](Preferences& p) { p.window_width = 900; }), std::invalid_argument);
    EXPECT_EQ(load_preferences(), Preferences{});
}

}  // namespace
}  // namespace relievo::preferences_test
