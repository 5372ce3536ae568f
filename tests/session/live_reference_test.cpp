// The reference beside a session: whole pictures, edits in their midst, questions.
#include "editor/session/live_reference.h"

#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <thread>

#include "tests/session/test_scene.h"

namespace relievo::live_reference_test {
namespace {

constexpr int kWidth = 53, kHeight = 37;

class LiveReferences : public testing::Test {
  protected:
    LiveReferences()
        : session_(test::write_scene(folder_.path()), test::headless()), reference_(session_, [] {}, 3) {}

    template <typename Condition>
    bool wait_for(Condition condition) {
        for (int i = 0; i < 6000; ++i) {
            reference_.take();
            if (condition()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return false;
    }

    // As the renders of the command line have it.
    ReferenceImage direct() const {
        const SceneObject& object = session_.scene().objects.front();
        const HeightMap& map = session_.map();
        const ReferenceObject one =
            reference_object(object, {map.width(), map.height(), map.texels().data()});
        return trace_image(ReferenceSurface(std::span(&one, 1)), session_.scene().camera,
                           session_.scene().origin, kWidth, kHeight);
    }

    void expect_picture_is_direct() {
        const ReferenceImage image = direct();
        std::size_t hits = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const auto i = static_cast<std::size_t>(y * kWidth + x);
                const auto sample = reference_.picture().at(x, y);
                ASSERT_TRUE(sample && sample->x == x && sample->y == y);
                ASSERT_EQ(sample->depth, image.depth[i]);
                ASSERT_EQ(sample->object, image.object[i]);
                hits += sample->object > 0 ? 1 : 0;
            }
        EXPECT_GT(hits, 100u);
    }

    test::TemporaryFolder folder_;
    Session session_;
    LiveReference reference_;
};

TEST(ReferencePictures, PassesCoarseToFineMeetEveryPixelOnce) {
    std::set<std::pair<int, int>> met;
    std::size_t count = 0;
    for (int step = ReferencePicture::kCoarsest; step > 0; step /= 2)
        for (int row = 0; row < kHeight; row += step)
            for (const int x : ReferencePicture::columns(kWidth, step, row)) {
                met.insert({x, row});
                ++count;
            }
    EXPECT_EQ(count, static_cast<std::size_t>(kWidth * kHeight));
    EXPECT_EQ(met.size(), count);
}

TEST(ReferencePictures, AnUnknownPixelShowsTheCoarserOneToItsUpperLeft) {
    ReferencePicture picture(kWidth, kHeight);
    EXPECT_FALSE(picture.at(5, 5));
    ReferencePicture::Strip strip{ReferencePicture::kCoarsest, 0, {}, {}};
    strip.depth.assign(ReferencePicture::columns(kWidth, strip.step, 0).size(), 2.5);
    strip.object.assign(strip.depth.size(), 1);
    picture.add(strip);
    ASSERT_TRUE(picture.at(17, 5));
    EXPECT_EQ(picture.at(17, 5)->x, 16);
    EXPECT_EQ(picture.at(17, 5)->y, 0);
    EXPECT_FALSE(picture.at(17, 16));
}

TEST_F(LiveReferences, TheWholePictureIsThatOfTheReference) {
    reference_.follow(kWidth, kHeight);
    ASSERT_TRUE(wait_for([&] { return reference_.progress() >= 1; }));
    expect_picture_is_direct();
}

TEST_F(LiveReferences, AnEditInItsMidstStartsAnotherPictureOfTheNewSurface) {
    reference_.follow(kWidth, kHeight);
    EXPECT_TRUE(reference_.is_current(kWidth, kHeight));
    session_.brush().strength = 1;
    test::sculpt(session_, 3, 20);
    EXPECT_FALSE(reference_.is_current(kWidth, kHeight));
    reference_.follow(kWidth, kHeight);
    session_.set("amplitude", 0.35);
    reference_.follow(kWidth, kHeight);
    ASSERT_TRUE(wait_for([&] { return reference_.progress() >= 1; }));
    expect_picture_is_direct();
}

TEST_F(LiveReferences, AQuestionIsAnsweredWhileAPictureIsUnderWayAndAfterAnEdit) {
    const ReferenceRay ray = reference_camera_ray(session_.scene().camera, session_.scene().origin, kWidth,
                                                  kHeight, kWidth / 2.0, kHeight / 2.0);
    for (const bool edit : {false, true}) {
        reference_.follow(kWidth, kHeight);
        if (edit) test::sculpt(session_, 4, 20);
        reference_.ask({glm::vec3(ray.origin), glm::vec3(ray.direction)});
        EXPECT_EQ(reference_.wants_picture(), !edit) << "a picture of an old surface is of no use";
        std::optional<ReferenceVerdict> verdict;
        ASSERT_TRUE(wait_for([&] { return (verdict = reference_.take_verdict()).has_value(); }));
        ASSERT_TRUE(verdict->hit);
        const ReferenceImage image = direct();
        const std::size_t middle = static_cast<std::size_t>(kHeight / 2 * kWidth + kWidth / 2);
        EXPECT_NEAR(verdict->hit->t, image.depth[middle], 1e-5);
        EXPECT_EQ(verdict->hit->face, image.face[middle]);
    }
}

TEST_F(LiveReferences, StoppedOrLeftInItsMidstItEndsAtOnce) {
    reference_.follow(4000, 3000);
    reference_.stop();
    EXPECT_FALSE(reference_.wants_picture());
    reference_.follow(4000, 3000);
}

}  // namespace
}  // namespace relievo::live_reference_test
