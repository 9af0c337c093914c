// SPDX-License-Identifier: BSD-3-Clause
// Lines come in the order of episodes, whatever the order of their ends.
#include "optimizer/report/results_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

namespace k3d::optimizer::report {
namespace {

class ResultsFileTest : public testing::Test {
  protected:
    ~ResultsFileTest() override { std::filesystem::remove(path_); }

    static episode::Result result(std::uint64_t seed) {
        episode::Result r;
        r.seed = seed;
        return r;
    }

    std::vector<std::uint64_t> seeds() const {
        std::ifstream in(path_);
        std::vector<std::uint64_t> seeds;
        for (std::string line; std::getline(in, line);) {
            seeds.push_back(k3d::episode::from_line(line).seed);
        }
        return seeds;
    }

    std::string path_ = testing::TempDir() + "k3d_results_" + std::to_string(::getpid());
};

using Seeds = std::vector<std::uint64_t>;

TEST_F(ResultsFileTest, ALineWaitsForThoseBeforeIt) {
    ResultsFile file(path_);
    file.settle(2, result(12));
    file.settle(1, std::nullopt);
    EXPECT_EQ(seeds(), Seeds{});
    file.settle(0, result(10));
    EXPECT_EQ(seeds(), (Seeds{10, 12}));
    file.settle(5, result(15));
    file.settle(4, result(14));
    EXPECT_EQ(seeds(), (Seeds{10, 12}));
    file.close();
    EXPECT_EQ(seeds(), (Seeds{10, 12, 14, 15}));
}

TEST_F(ResultsFileTest, TheFirstLineTakesThePlaceOfWhatTheFileHeld) {
    ResultsFile(path_).settle(0, result(1));
    { ResultsFile nothing_came(path_); }
    EXPECT_EQ(seeds(), Seeds{1}) << "nothing is there to take its place";
    ResultsFile file(path_);
    file.settle(0, std::nullopt);
    EXPECT_EQ(seeds(), Seeds{1});
    file.settle(1, result(3));
    file.settle(2, result(4));
    EXPECT_EQ(seeds(), (Seeds{3, 4}));
}

TEST_F(ResultsFileTest, WithoutAnyResultItIsEmptyAtTheEnd) {
    ResultsFile(path_).settle(0, result(1));
    ResultsFile file(path_);
    file.settle(0, std::nullopt);
    file.close();
    EXPECT_EQ(seeds(), Seeds{});
}

TEST_F(ResultsFileTest, WhatWaitsIsNotLostWithAnError) {
    ResultsFile(path_).settle(1, result(2));
    EXPECT_EQ(seeds(), Seeds{2});
}

TEST_F(ResultsFileTest, NamesAFileThatCannotBeWritten) {
    try {
        ResultsFile file("/nowhere/out.jsonl");
        ADD_FAILURE();
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "cannot write results to /nowhere/out.jsonl");
    }
}

}  // namespace
}  // namespace k3d::optimizer::report
