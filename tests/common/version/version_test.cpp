// SPDX-License-Identifier: BSD-3-Clause
// The script that names the code's version, on trees without git: two codes never share a name.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace {

namespace fs = std::filesystem;

class VersionWithoutGit : public testing::Test {
  protected:
    VersionWithoutGit() {
        fs::create_directories(tree_ / "server");
        write("CMakeLists.txt", "project(x)");
        write("server/main.cpp", "int main() {}");
    }
    ~VersionWithoutGit() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) {
        std::ofstream(tree_ / name) << text;
    }

    /// The file that the script writes for the tree.
    std::string version() {
        const fs::path out = folder_ / "version.cpp";
        const std::string command = "cmake -DOUT=" + out.string() + " -DVERSION=1.2.3 -DSOURCE=" +
                                    tree_.string() + " -P " K3D_SOURCE_DIR
                                    "/common/version/generate.cmake";
        EXPECT_EQ(std::system(command.c_str()), 0);
        std::ostringstream text;
        text << std::ifstream(out).rdbuf();
        return text.str();
    }

    fs::path folder_ = fs::path(testing::TempDir()) / ("k3d-version-" + std::to_string(getpid()));

  private:
    fs::path tree_ = folder_ / "tree";
};

TEST_F(VersionWithoutGit, ChangesWithTheCode) {
    const std::string first = version();
    EXPECT_NE(first.find("\"1.2.3+files-"), std::string::npos) << first;
    EXPECT_EQ(version(), first);
    write("server/main.cpp", "int main() { return 1; }");
    const std::string edited = version();
    EXPECT_NE(edited, first);
    write("server/more.h", "");
    EXPECT_NE(version(), edited);
}

TEST_F(VersionWithoutGit, IsNotThatOfAForeignCheckoutAround) {
    const std::string alone = version();
    const std::string git = "cd " + folder_.string() + " && git init -q . && git -c user.name=x -c "
                            "user.email=x@y commit -q --allow-empty -m x";
    ASSERT_EQ(std::system(git.c_str()), 0);
    EXPECT_EQ(version(), alone);
}

}  // namespace
