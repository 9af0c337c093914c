// SPDX-License-Identifier: BSD-3-Clause
// Loading, printing and setting described structs, and every kind of fault with its place.
#include "common/config/config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

namespace k3d::config {
namespace {

using testing::HasSubstr;

struct Walk {
    double step_height = 0.03;
    std::vector<double> gains{1.0, 2.0};
    void describe(Fields& f) {
        f.number("step_height", step_height, {0.0, 0.1}, "m", "how high the swing foot is lifted");
        f.numbers("gains", gains, {-5.0, 5.0}, "", "gains of the balance");
    }
};

struct Match {
    Walk walk;
    int port = 3100;
    std::uint64_t seed = 1;
    bool noise = true;
    std::string pace = "realtime";
    std::string name = "a \"b\" \\ \n c";
    double free = 0.5;

    void describe(Fields& f) {
        f.section("walk", walk);  // on purpose before the plain fields
        f.integer("port", port, {0, 65535}, "", "where agents connect");
        f.seed("seed", seed, "all randomness follows from it");
        f.boolean("noise", noise, "noise of vision");
        f.text("pace", pace, {"realtime", "sync", "fast"}, "who waits for whom");
        f.text("name", name, {}, "any text");
        f.number("free", free, {-kInf, kInf}, "", "any number");
    }
    static constexpr double kInf = std::numeric_limits<double>::infinity();
};

std::string fault_of(const std::string& toml) {
    Match run;
    const std::string before = print(describing(run));
    try {
        load_text(describing(run), toml, "run.toml");
    } catch (const ConfigError& error) {
        EXPECT_EQ(print(describing(run)), before) << "a faulty text must change nothing";
        return error.what();
    }
    return "no fault";
}

TEST(ConfigLoad, SetsWhatIsNamedAndLeavesTheRest) {
    Match run;
    load_text(describing(run),
              "port = 0\nnoise = false\npace = \"fast\"\nfree = 3\nseed = 7\n"
              "[walk]\ngains = [0, -1.5]\n",
              "run.toml");
    EXPECT_EQ(run.port, 0);
    EXPECT_FALSE(run.noise);
    EXPECT_EQ(run.pace, "fast");
    EXPECT_EQ(run.free, 3.0);
    EXPECT_EQ(run.seed, 7U);
    EXPECT_EQ(run.walk.gains, (std::vector<double>{0.0, -1.5}));
    EXPECT_EQ(run.walk.step_height, 0.03);
}

TEST(ConfigLoad, NamesFileLineAndNearestKey) {
    EXPECT_EQ(fault_of("port = 1\n\n[walk]\nstep_hight = 0.02\n"),
              "run.toml:4: unknown key \"walk.step_hight\", the nearest known one is "
              "\"walk.step_height\"");
    EXPECT_EQ(fault_of("step_height = 0.02\n"),
              "run.toml:1: unknown key \"step_height\", the nearest known one is "
              "\"walk.step_height\"");
    EXPECT_THAT(fault_of("[wlk]\ngains = [1, 2]\n"), HasSubstr("nearest known one is \"walk\""));
    EXPECT_THAT(fault_of("\"walk.gains\" = [1, 2]\n"), HasSubstr("unknown key"));
}

TEST(ConfigLoad, NamesWrongTypes) {
    EXPECT_EQ(fault_of("port = 1.5"), "run.toml:1: \"port\" is a number, wanted is a whole number");
    EXPECT_EQ(fault_of("noise = 1"),
              "run.toml:1: \"noise\" is a whole number, wanted is true or false");
    EXPECT_EQ(fault_of("pace = 1"),
              "run.toml:1: \"pace\" is a whole number, wanted is a text in quotes");
    EXPECT_EQ(fault_of("free = \"x\""), "run.toml:1: \"free\" is a text, wanted is a number");
    EXPECT_EQ(fault_of("seed = true"),
              "run.toml:1: \"seed\" is true or false, wanted is a whole number");
    EXPECT_EQ(fault_of("walk = 3"), "run.toml:1: \"walk\" is a value, wanted is a section");
    EXPECT_EQ(fault_of("[port]\nx = 1"),
              "run.toml:1: \"port\" is a section, wanted is a whole number\n"
              "run.toml:2: unknown key \"port.x\", the nearest known one is \"port\"");
    EXPECT_EQ(fault_of("[walk]\ngains = 1"),
              "run.toml:2: \"walk.gains\" is a whole number, wanted is a list of numbers");
}

TEST(ConfigLoad, NamesValuesOutOfRange) {
    EXPECT_EQ(fault_of("port = 65536"), "run.toml:1: \"port\" is 65536, allowed is 0 to 65535");
    EXPECT_EQ(fault_of("seed = -1"),
              "run.toml:1: \"seed\" is -1, allowed is 0 to 18446744073709551615");
    EXPECT_EQ(fault_of("seed = \"18446744073709551616\""),
              "run.toml:1: \"seed\" is 18446744073709551616, allowed is 0 to "
              "18446744073709551615");
    EXPECT_EQ(fault_of("free = nan"), "run.toml:1: \"free\" is not finite");
    EXPECT_EQ(fault_of("free = inf"), "run.toml:1: \"free\" is not finite");
    EXPECT_EQ(fault_of("pace = \"slow\""),
              "run.toml:1: \"pace\" is \"slow\", allowed is \"realtime\" \"sync\" \"fast\"");
    EXPECT_EQ(fault_of("[walk]\ngains = [1, 9]"),
              "run.toml:2: \"walk.gains\" entry 2 is 9, allowed is -5 to 5");
    EXPECT_EQ(fault_of("[walk]\ngains = [1]"),
              "run.toml:2: \"walk.gains\" has 1 entries, wanted are 2");
}

TEST(ConfigLoad, ReportsAllFaultsInTheOrderOfTheLines) {
    EXPECT_EQ(fault_of("prt = 1\nport = -1\n"),
              "run.toml:1: unknown key \"prt\", the nearest known one is \"port\"\n"
              "run.toml:2: \"port\" is -1, allowed is 0 to 65535");
}

TEST(ConfigLoad, NamesTheLineOfASyntaxFault) {
    EXPECT_THAT(fault_of("port = 1\nnoise = = 2\n"), testing::StartsWith("run.toml:2: "));
    EXPECT_THAT(fault_of("port = 1\nport = 2\n"), testing::StartsWith("run.toml:2: "));
}

TEST(ConfigLoad, LettersBeyondAsciiStandInQuotesAndCommentsOnly) {
    const std::string fault = "a letter beyond ASCII stands outside quotes and comments";
    EXPECT_EQ(fault_of("port = 1\nst\u00E4rke = 1\n"), "run.toml:2: " + fault);
    EXPECT_EQ(fault_of("\u044F"), "run.toml:1: " + fault);
    EXPECT_EQ(fault_of("name = \"\"\"\n\\\u044F\"\"\""), "run.toml:2: " + fault);
    EXPECT_THAT(fault_of("name = \"\xFF\""), testing::StartsWith("run.toml:1: "));
    Match run;
    load_text(describing(run),
              "\xEF\xBB\xBF# gr\u00FC\u00DFe \"\nname = \"J\u00FCrgen \\\" #\" # '\u00E4\n"
              "pace = 'sync'\nport = 7\n",
              "run.toml");
    EXPECT_EQ(run.name, "J\u00FCrgen \" #");
    EXPECT_EQ(run.pace, "sync");
    EXPECT_EQ(run.port, 7);
}

TEST(ConfigLoad, FilesThatCannotBeReadAreNamed) {
    Match run;
    const std::string missing = testing::TempDir() + "k3d_no_such.toml";
    try {
        load_file(describing(run), missing);
        FAIL() << "a missing file was read";
    } catch (const ConfigError& error) {
        EXPECT_EQ(error.what(), missing + ": cannot read: No such file or directory");
    }
    EXPECT_THROW(load_file(describing(run), testing::TempDir()), ConfigError);
}

TEST(ConfigLoad, ReadsFiles) {
    const std::string path = testing::TempDir() + "k3d_config_test_" + std::to_string(getpid());
    std::ofstream(path) << "port = 17\n";
    Match run;
    load_file(describing(run), path);
    EXPECT_EQ(run.port, 17);
    std::ofstream(path) << "";
    EXPECT_NO_THROW(load_file(describing(run), path)) << "an empty file names nothing";
    std::remove(path.c_str());
}

TEST(ConfigPrint, RoundTripsEveryKindOfField) {
    Match written;
    written.walk.step_height = 0.1 / 3.0;
    written.walk.gains = {1e-7, -4.0};
    written.port = 1;
    written.seed = std::numeric_limits<std::uint64_t>::max();
    written.noise = false;
    written.pace = "sync";
    written.free = -1e300;
    const std::string text = print(describing(written));
    Match read;
    load_text(describing(read), text, "printed");
    EXPECT_EQ(print(describing(read)), text);
    EXPECT_EQ(read.walk.step_height, written.walk.step_height);
    EXPECT_EQ(read.walk.gains, written.walk.gains);
    EXPECT_EQ(read.seed, written.seed);
    EXPECT_EQ(read.name, written.name);
    EXPECT_EQ(read.free, written.free);
}

TEST(ConfigPrint, ShowsUnitRangeAndMeaning) {
    Match run;
    const std::string text = print(describing(run));
    EXPECT_THAT(text, HasSubstr("[walk]\nstep_height = 0.03  # m, 0 to 0.1: how high the swing "
                                "foot is lifted\n"));
    EXPECT_THAT(text, HasSubstr("pace = \"realtime\"  # realtime | sync | fast: who waits"));
    EXPECT_LT(text.find("port ="), text.find("[walk]")) << "plain fields come before sections";
}

TEST(ConfigSet, SetsByPathWithoutTomlQuotes) {
    Match run;
    const Describe d = describing(run);
    set(d, "walk.step_height", "0.05");
    set(d, "walk.gains", "1,2.5");
    set(d, "port", "5");
    set(d, "seed", "18446744073709551615");
    set(d, "noise", "false");
    set(d, "pace", "sync");
    EXPECT_EQ(run.walk.step_height, 0.05);
    EXPECT_EQ(run.walk.gains, (std::vector<double>{1.0, 2.5}));
    EXPECT_EQ(run.port, 5);
    EXPECT_EQ(run.seed, std::numeric_limits<std::uint64_t>::max());
    EXPECT_FALSE(run.noise);
    EXPECT_EQ(run.pace, "sync");
}

std::string set_fault(std::string_view path, std::string_view value) {
    Match run;
    try {
        set(describing(run), path, value);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "no fault";
}

TEST(ConfigAssignments, AreWhatSetTakes) {
    Match run;
    run.walk = {.step_height = 0.071234567890123456, .gains = {-1.5, 1e-9}};
    run.port = 17;
    run.seed = 18446744073709551615u;
    run.noise = false;
    run.pace = "fast";
    run.free = -1e300;
    const std::string text = print(describing(run));
    Match back;
    for (const std::string& assignment : assignments(text, "run.toml")) {
        const auto equals = assignment.find('=');
        set(describing(back), assignment.substr(0, equals), assignment.substr(equals + 1));
    }
    EXPECT_EQ(print(describing(back)), text);
    EXPECT_TRUE(assignments("# nothing\n", "run.toml").empty());
}

TEST(ConfigAssignments, OfWhatNoSettingCanBeAreFaults) {
    const auto fault = [](const std::string& text) -> std::string {
        try {
            assignments(text, "run.toml");
        } catch (const ConfigError& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_THAT(fault("[walk]\nborn = 2020-01-01\n"), HasSubstr("run.toml:2: \"walk.born\""));
    EXPECT_THAT(fault("gains = [1.0, \"two\"]\n"), HasSubstr("run.toml:1: \"gains\""));
    EXPECT_THAT(fault("gains = [1.0\n"), HasSubstr("run.toml:"));
    EXPECT_THROW(assignments_of_file("/nowhere/run.toml"), ConfigError);
}

TEST(ConfigSet, NamesPathAndValueOfAFault) {
    EXPECT_EQ(set_fault("walk.step_heigt", "1"),
              "unknown key \"walk.step_heigt\", the nearest known one is \"walk.step_height\"");
    EXPECT_EQ(set_fault("walk.step_height", "1"), "\"walk.step_height\" is 1, allowed is 0 to 0.1");
    EXPECT_EQ(set_fault("port", "abc"), "\"port\" is \"abc\", which is no value");
    EXPECT_EQ(set_fault("port", "1\nnoise = false"),
              "\"port\" is \"1\\u000Anoise = false\", which is no value");
    EXPECT_EQ(set_fault("port", "\u00E4"), "\"port\" is \"\u00E4\", which is no value");
    EXPECT_EQ(set_fault("port", ""), "\"port\" is \"\", which is no value");
    EXPECT_EQ(set_fault("walk", "1"), "\"walk\" is a section, wanted is a value in it");
}

TEST(ConfigFields, TellPathTypeValueAndRange) {
    Match run;
    const auto list = nlohmann::json::parse(print_fields(describing(run)));
    ASSERT_EQ(list.size(), 8U);
    EXPECT_EQ(list[0].dump(),
              R"({"max":0.1,"meaning":"how high the swing foot is lifted","min":0.0,)"
              R"("path":"walk.step_height","type":"number","unit":"m","value":0.03})");
    EXPECT_EQ(list[1]["type"], "numbers");
    EXPECT_EQ(list[2]["type"], "integer");
    EXPECT_EQ(list[3]["type"], "seed");
    EXPECT_EQ(list[4]["type"], "boolean");
    EXPECT_EQ(list[6]["value"], "a \"b\" \\ \n c");
    EXPECT_TRUE(list[7]["min"].is_null());
}

TEST(ConfigLines, OfValuesAndSections) {
    const std::string text = "port = 0\n\n[walk]\nstep_height = 0.05\n[a.b]\n";
    EXPECT_EQ(line_of(text, "port"), 1);
    EXPECT_EQ(line_of(text, "walk"), 3);
    EXPECT_EQ(line_of(text, "walk.step_height"), 4);
    EXPECT_EQ(line_of(text, "a.b"), 5);
    EXPECT_EQ(line_of(text, "walk.gains"), std::nullopt);
    EXPECT_EQ(line_of("= 3", "port"), std::nullopt);
}

}  // namespace
}  // namespace k3d::config
