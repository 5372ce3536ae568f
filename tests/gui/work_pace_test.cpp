// How much of its time long work has for itself.
#include "editor/gui/work_pace.h"

#include <gtest/gtest.h>

namespace relievo::gui::work_pace_test {
namespace {

struct Shown {
    int frames = 0;
    double share = 0;  // of the time
};

// Ten seconds of work in pieces, between which a frame is drawn when it is due.
Shown work(double piece_ms, double frame_ms) {
    constexpr double kWholeMs = 10e3;
    WorkPace pace;
    Shown shown;
    double now = 0;
    while (now < kWholeMs) {
        now += piece_ms;
        if (!pace.due(now)) continue;
        ++shown.frames;
        pace.drawn(now, now + frame_ms);
        now += frame_ms;
    }
    shown.share = shown.frames * frame_ms / now;
    return shown;
}

TEST(WorkPace, FramesOfALargeWindowWithoutAGpuLeaveMostOfTheTimeToTheWork) {
    for (const double frame_ms : {40.0, 100.0, 400.0}) {
        const Shown shown = work(30, frame_ms);
        EXPECT_LE(shown.share, 0.25) << frame_ms;
        EXPECT_GE(shown.frames, 4) << "the bar still moves";
    }
}

TEST(WorkPace, QuickFramesShowAnEvenBar) {
    const Shown shown = work(10, 2);
    EXPECT_GT(shown.frames, 150);
    EXPECT_LT(shown.share, 0.05);
}

TEST(WorkPace, TheBarStandsThereFromTheSecondFrameOnWhichFollowsAtOnce) {
    WorkPace pace;
    EXPECT_TRUE(pace.due(0));
    pace.drawn(0, 100);
    EXPECT_TRUE(pace.due(101));
    pace.drawn(101, 201);
    EXPECT_FALSE(pace.due(300));
    EXPECT_TRUE(pace.due(601));
}

}  // namespace
}  // namespace relievo::gui::work_pace_test
