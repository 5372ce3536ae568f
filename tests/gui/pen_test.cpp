// A pen's pressure without a pen: which axis it is, what its values mean, and which event it belongs to.
#include <gtest/gtest.h>

#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "editor/gui/pen_axis.h"
#include "editor/gui/pen_track.h"

namespace relievo::gui::pen_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Kind = PenSample::Kind;

TEST(PenAxis, PressureIsFoundByItsLabel) {
    const std::vector<PointerAxis> pen{{0, "Abs X", 0, 44704},
                                       {1, "Abs Y", 0, 27940},
                                       {2, "Abs Pressure", 0, 65536},
                                       {3, "Abs Tilt X", -64, 63}};
    EXPECT_EQ(pressure_axis(pen).value().number, 2);
    const std::vector<PointerAxis> mouse{{0, "Rel X", -1, -1}, {1, "Rel Y", -1, -1}};
    EXPECT_FALSE(pressure_axis(mouse));
    EXPECT_FALSE(pressure_axis({}));
}

TEST(PenAxis, APensPressureComesBeforeAFingers) {
    const std::vector<PointerAxis> both{{4, "Abs MT Pressure", 0, 255}, {2, "Abs Pressure", 0, 1023}};
    EXPECT_EQ(pressure_axis(both).value().number, 2);
    EXPECT_EQ(pressure_axis(std::span(both).first(1)).value().number, 4);
}

TEST(PenAxis, AnAxisWithoutARangeIsNone) {
    for (const auto& [low, high] :
         {std::pair{0.0, 0.0}, {1.0, 0.0}, {-1.0, -1.0}, {0.0, kNan}, {-kInfinity, 1.0}})
        EXPECT_FALSE(pressure_axis(std::vector<PointerAxis>{{2, "Abs Pressure", low, high}}))
            << low << " " << high;
}

TEST(PenAxis, PressureRunsFromTheLeastToTheMost) {
    const PressureAxis axis{2, -100, 300};
    EXPECT_EQ(pressure_of(-100, axis), 0);
    EXPECT_EQ(pressure_of(0, axis), 0.25);
    EXPECT_EQ(pressure_of(300, axis), 1);
    EXPECT_EQ(pressure_of(-101, axis), 0) << "drivers overshoot";
    EXPECT_EQ(pressure_of(1e9, axis), 1);
    EXPECT_EQ(pressure_of(kNan, axis), 1);
    constexpr double kMost = std::numeric_limits<double>::max();
    EXPECT_NEAR(pressure_of(0, {2, -kMost, kMost}), 0.5, 1e-15);
}

TEST(PenAxis, TheOtherEndIsToldByItsName) {
    EXPECT_TRUE(is_eraser("Wacom Intuos Pro M Pen eraser"));
    EXPECT_TRUE(is_eraser("Wacom Intuos Pro M Pen Eraser (0x8040001)"));
    EXPECT_TRUE(is_eraser("ERASER"));
    EXPECT_FALSE(is_eraser("Wacom Intuos Pro M Pen stylus"));
    EXPECT_FALSE(is_eraser("erase"));
    EXPECT_FALSE(is_eraser(""));
}

PenSample moved(double x, double y, double pressure) {
    return {Kind::move, x, y, {pressure, false}};
}

TEST(PenTrack, WithoutSamplesEverythingPressesFully) {
    PenTrack track;
    EXPECT_EQ(track.touch_at(Kind::press, 10, 10), PenTouch{});
    EXPECT_FALSE(track.settle());
}

TEST(PenTrack, EachOfManyEventsInOneFrameHasItsOwnPressure) {
    for (const int lag : {0, 1}) {  // samples that say where the pointer is, and where it was
        PenTrack track;
        for (int i = 0; i < 8; ++i) track.add(moved(10.75 + i - lag, 20.5, 0.1 * i));
        for (int i = 0; i < 8; ++i)
            EXPECT_EQ(track.touch_at(Kind::move, 10 + i, 20).pressure, 0.1 * i) << lag;
    }
}

TEST(PenTrack, SamplesWithinAPixelOfWhichGlfwMakesOneEventAreSteppedOver) {
    PenTrack track;
    for (int i = 0; i < 9; ++i) track.add(moved(10 + i / 3.0, 20, 0.1 * i));
    EXPECT_EQ(track.touch_at(Kind::move, 10, 20).pressure, 0);
    EXPECT_NEAR(track.touch_at(Kind::move, 11, 20).pressure, 0.25, 0.06);
    EXPECT_NEAR(track.touch_at(Kind::move, 12, 20).pressure, 0.55, 0.06);
}

TEST(PenTrack, AStrokeThatCrossesItselfTakesTheFirstOfTheTwo) {
    PenTrack track;
    for (const PenSample& sample : {moved(5, 5, 0.1), moved(6, 5, 0.2), moved(5, 5, 0.3)}) track.add(sample);
    EXPECT_EQ(track.touch_at(Kind::move, 5, 5).pressure, 0.1);
    EXPECT_EQ(track.touch_at(Kind::move, 6, 5).pressure, 0.2);
    EXPECT_EQ(track.touch_at(Kind::move, 5, 5).pressure, 0.3);
}

TEST(PenTrack, PressAndReleaseTakeTheirOwnWhereverThePointerWas) {
    PenTrack track;
    track.add(moved(5, 5, 0));
    track.add({Kind::press, 5.5, 5.5, {0.25, true}});
    track.add({Kind::release, 90, 90, {0.125, true}});
    EXPECT_EQ(track.touch_at(Kind::press, 4, 4), (PenTouch{0.25, true}));
    EXPECT_EQ(track.touch_at(Kind::release, 4, 4), (PenTouch{0.125, true}));
}

TEST(PenTrack, AMouseAfterAPenPressesFullyAgain) {
    PenTrack track;
    track.add(moved(5, 5, 0));
    track.add(moved(6, 6, 1));
    EXPECT_EQ(track.touch_at(Kind::move, 5, 5).pressure, 0);
    EXPECT_EQ(track.touch_at(Kind::move, 6, 6).pressure, 1);
}

TEST(PenTrack, AnEventThatIsAheadOfItsSampleGoesOnAsBefore) {
    PenTrack track;
    track.add(moved(5, 5, 0.5));
    EXPECT_EQ(track.touch_at(Kind::move, 5, 5).pressure, 0.5);
    EXPECT_EQ(track.touch_at(Kind::move, 6, 5).pressure, 0.5);
    track.add(moved(6, 5, 0.75));
    EXPECT_FALSE(track.settle()) << "a round of patience";
    EXPECT_TRUE(track.settle());
    EXPECT_EQ(track.now().pressure, 0.75);
    EXPECT_FALSE(track.settle());
}

TEST(PenTrack, SamplesThatNoEventAsksForDoNotPileUpInItsWay) {
    PenTrack track;
    for (int round = 0; round < 3; ++round) {
        for (int i = 0; i < 100; ++i) track.add(moved(1000 + i, 0, 0.5));
        track.settle();
    }
    track.add(moved(6, 6, 0.25));
    track.add(moved(7, 7, 0.75));
    EXPECT_EQ(track.now().pressure, 0.5);
    EXPECT_EQ(track.touch_at(Kind::move, 7, 7).pressure, 0.25);
    EXPECT_FALSE(track.settle());
    EXPECT_TRUE(track.settle());
    EXPECT_EQ(track.now().pressure, 0.75);
    EXPECT_FALSE(track.settle()) << "none is left";
}

}  // namespace
}  // namespace relievo::gui::pen_test
