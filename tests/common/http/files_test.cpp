// SPDX-License-Identifier: BSD-3-Clause
// Tests for common/http/files.cpp.
#include "common/http/files.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <sys/stat.h>

#include "common/http/temporary_folder.h"

namespace k3d::http {
namespace {

class FilesTest : public testing::Test {
  protected:
    FilesTest() {
        outside_.write("web/index.html", "page");
        outside_.write("web/lib/a b.js", "code");
        outside_.write("web/lib/index.html", "lib");
        outside_.write("web/.hidden", "secret");
        outside_.write("secret.txt", "secret");
        outside_.write("web-secret/x.txt", "secret");
        std::filesystem::create_symlink(outside_.path() / "secret.txt", root() / "link.txt");
        std::filesystem::create_symlink(outside_.path() / "web-secret", root() / "linked");
        std::filesystem::create_symlink(root() / "index.html", root() / "same.html");
        ::mkfifo((root() / "pipe").c_str(), 0600);
    }
    std::filesystem::path root() const { return outside_.path() / "web"; }
    std::string found(std::string_view target) const {
        const Found result = find_file(root(), target);
        if (result.what != Found::What::File) return "";
        return std::filesystem::relative(result.file, std::filesystem::canonical(root())).string();
    }
    Found::What what(std::string_view target) const { return find_file(root(), target).what; }

    test::TemporaryFolder outside_;
};

TEST_F(FilesTest, FindsFilesOfTheFolder) {
    EXPECT_EQ(found("/"), "index.html");
    EXPECT_EQ(found("/index.html"), "index.html");
    EXPECT_EQ(found("/index.html?robot=3"), "index.html");
    EXPECT_EQ(found("/lib/a%20b.js"), "lib/a b.js");
    EXPECT_EQ(found("/lib"), "lib/index.html");
    EXPECT_EQ(found("//index.html"), "index.html");
    EXPECT_EQ(found("/same.html"), "index.html");
}

TEST_F(FilesTest, ServesNothingElse) {
    for (const char* target :
         {"/../secret.txt", "/%2e%2e/secret.txt", "/lib/../../secret.txt",
          "/lib/%2E./../secret.txt", "/..%2fsecret.txt", "/.hidden", "/link.txt", "/linked/x.txt",
          "/../web-secret/x.txt", "/none.js", "/index.html/", "/pipe", "//etc/passwd", "/lib/.."}) {
        EXPECT_EQ(what(target), Found::What::Missing) << target;
    }
    EXPECT_EQ(what("/" + std::string(100'000, 'a')), Found::What::Missing);
}

TEST_F(FilesTest, NamesMalformedTargets) {
    using namespace std::string_view_literals;
    for (const std::string_view target :
         {""sv, "index.html"sv, "*"sv, "http://x/index.html"sv, "/%"sv, "/%4"sv, "/%zz"sv,
          "/index.html%00"sv, "/..\\secret.txt"sv, "/%5c"sv}) {
        EXPECT_EQ(what(target), Found::What::Malformed) << target;
        EXPECT_FALSE(find_file(root(), target).reason.empty());
    }
}

TEST_F(FilesTest, NoTargetLeadsOutside) {
    const std::filesystem::path folder = std::filesystem::canonical(root());
    const bool held = rc::check("whatever is found lies in the folder", [&] {
        const auto parts =
            *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
                "/", "..", ".", "%2e", "%2f", "web", "secret.txt", "index.html", "lib", "linked",
                "%", "a b.js", "\\", "?", "x.txt", "web-secret"));
        std::string target = "/";
        for (const std::string& part : parts) target += part;
        const Found result = find_file(root(), target);
        if (result.what != Found::What::File) return;
        RC_ASSERT(result.file.string().rfind(folder.string() + "/", 0) == 0);
    });
    EXPECT_TRUE(held);
}

TEST(MimeTypeTest, KnowsWhatThePageIsMadeOf) {
    EXPECT_EQ(mime_type("index.html"), "text/html; charset=utf-8");
    EXPECT_EQ(mime_type("a/three.module.min.js"), "text/javascript; charset=utf-8");
    EXPECT_EQ(mime_type("page.css"), "text/css; charset=utf-8");
    EXPECT_EQ(mime_type("LICENSE"), "application/octet-stream");
}

}  // namespace
}  // namespace k3d::http
