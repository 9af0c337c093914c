// SPDX-License-Identifier: BSD-3-Clause
// Tests for server/viewer/viewer.cpp: who is told what, and when.
#include "server/viewer/viewer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "common/http/raw_peer.h"
#include "common/http/server.h"
#include "common/http/temporary_folder.h"
#include "server/viewer/sample_scene.h"

namespace k3d::server::viewer {
namespace {

using nlohmann::json;
using test::RawPeer;

class ViewerTest : public testing::Test {
  protected:
    ViewerTest() {
        folder_.write("index.html", "<p>page</p>");
        viewer_ =
            std::make_unique<Viewer>(loop_, "127.0.0.1", std::uint16_t{0}, folder_.path().string());
    }
    /// Publishes `scene` until the page has got a message, and returns that.
    json told(RawPeer& page, const SceneView& scene) {
        std::string text;
        EXPECT_TRUE(page.until(loop_, [&] {
            viewer_->publish(scene);
            return page.cut_message(text);
        }));
        return json::parse(text);
    }
    /// Publishes until a message fulfils `wanted`; messages on the way may be older.
    bool told_eventually(RawPeer& page, const SceneView& scene,
                         const std::function<bool(const json&)>& wanted) {
        return page.until(loop_, [&] {
            viewer_->publish(scene);
            std::string text;
            while (page.cut_message(text)) {
                if (wanted(json::parse(text))) return true;
            }
            return false;
        });
    }

    test::TemporaryFolder folder_;
    net::Loop loop_;
    std::unique_ptr<Viewer> viewer_;
};

TEST_F(ViewerTest, TellsTheSceneFirstAndThenMoments) {
    EXPECT_FALSE(viewer_->watched());
    viewer_->publish(sample_scene());  // to nobody
    RawPeer page(viewer_->port());
    ASSERT_TRUE(page.open_socket(loop_));
    EXPECT_TRUE(viewer_->watched());
    SceneView scene = sample_scene();
    EXPECT_EQ(told(page, scene)["kind"], "scene");
    scene.time = 99;
    EXPECT_TRUE(told_eventually(page, scene, [](const json& message) {
        EXPECT_EQ(message["kind"], "moment");
        return message["time"] == 99;
    }));
}

TEST_F(ViewerTest, TellsTheSceneAgainWhenRobotsChange) {
    RawPeer page(viewer_->port());
    ASSERT_TRUE(page.open_socket(loop_));
    SceneView scene = sample_scene();
    EXPECT_EQ(told(page, scene)["robots"].size(), 2u);
    scene.robots.push_back(sample_robot(wire::Side::Left, 2, 1));
    EXPECT_TRUE(told_eventually(page, scene, [](const json& message) {
        // No moment with three robots before the scene that says so.
        EXPECT_TRUE(message["kind"] == "scene" || message["robots"].size() == 2);
        return message["kind"] == "scene" && message["robots"].size() == 3;
    }));
    EXPECT_TRUE(told_eventually(page, scene, [](const json& message) {
        return message["kind"] == "moment" && message["robots"].size() == 3;
    }));
}

TEST_F(ViewerTest, AnAreaThatShrinksIsToldInMoments) {
    RawPeer page(viewer_->port());
    ASSERT_TRUE(page.open_socket(loop_));
    SceneView scene = sample_scene();
    EXPECT_EQ(told(page, scene)["kind"], "scene");
    for (const double side : {9.9, 9.8}) {
        scene.area = Vec2::Constant(side);
        EXPECT_TRUE(told_eventually(page, scene, [side](const json& message) {
            EXPECT_EQ(message["kind"], "moment")
                << "robots would be built anew, beliefs never told";
            return message["area"] == json({side, side});
        }));
    }
}

TEST_F(ViewerTest, EachPageIsToldTheScene) {
    RawPeer first(viewer_->port());
    ASSERT_TRUE(first.open_socket(loop_));
    const SceneView scene = sample_scene();
    EXPECT_EQ(told(first, scene)["kind"], "scene");
    EXPECT_EQ(told(first, scene)["kind"], "moment");
    RawPeer second(viewer_->port());
    ASSERT_TRUE(second.open_socket(loop_));
    EXPECT_EQ(told(second, scene)["kind"], "scene");
    EXPECT_TRUE(told_eventually(first, scene,
                                [](const json& message) { return message["kind"] == "moment"; }));
}

TEST_F(ViewerTest, NobodyWatchesAfterThePageIsClosed) {
    auto page = std::make_unique<RawPeer>(viewer_->port());
    ASSERT_TRUE(page->open_socket(loop_));
    RawPeer reader(viewer_->port());  // reads a file, watches nothing
    reader.send("GET / HTTP/1.1\r\nHost: x\r\n\r\n");
    EXPECT_THAT(reader.answer(loop_), testing::HasSubstr("<p>page</p>"));
    page.reset();
    EXPECT_TRUE(
        loop_.wait(net::Clock::now() + test::kPatience, [this] { return !viewer_->watched(); }));
    viewer_->publish(sample_scene());
}

TEST_F(ViewerTest, ShortVisitsWhileNothingIsPublishedLeaveRoomForMore) {
    const int more_than_at_once = static_cast<int>(http::Limits{}.connections) + 6;
    for (int i = 0; i < more_than_at_once; ++i) {
        auto page = std::make_unique<RawPeer>(viewer_->port());
        ASSERT_TRUE(page->open_socket(loop_)) << "visit " << i + 1;
        page.reset();
        ASSERT_TRUE(loop_.wait(net::Clock::now() + test::kPatience,
                               [this] { return !viewer_->watched(); }));
    }
}

TEST_F(ViewerTest, SaysWhatIsMissing) {
    const auto message = [this](const std::string& address, std::uint16_t port,
                                const std::string& folder) {
        try {
            Viewer viewer(loop_, address, port, folder);
        } catch (const std::runtime_error& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_EQ(message("127.0.0.1", 0, "/nowhere/web"),
              "no page in /nowhere/web (no index.html): install npm, then configure and build "
              "again");
    EXPECT_EQ(message("127.0.0.1", viewer_->port(), folder_.path().string()),
              "cannot listen on 127.0.0.1:" + std::to_string(viewer_->port()) +
                  ": Address already in use");
}

TEST(WebFolderTest, IsBesideTheProgramsFolder) {
    EXPECT_EQ(web_folder_beside_program(),
              std::filesystem::path(K3D_BIN_DIR).parent_path().string() + "/web");
}

}  // namespace
}  // namespace k3d::server::viewer
