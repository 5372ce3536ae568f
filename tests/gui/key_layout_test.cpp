// Letters are what is printed on the keys, all else is where it lies.
#include "editor/gui/key_layout.h"

#include <gtest/gtest.h>

namespace relievo::gui::key_layout_test {
namespace {

constexpr int kEscape = 256, kKeypad1 = 321;  // GLFW's

TEST(KeyLayout, AmericanKeysAreThemselves) {
    for (char key = 'A'; key <= 'Z'; ++key) {
        const char name[] = {static_cast<char>(key - 'A' + 'a'), '\0'};
        EXPECT_EQ(key_on_layout(key, name), key);
    }
    for (const char* sign : {"1", "[", "]", ";", ",", "'"}) EXPECT_EQ(key_on_layout(sign[0], sign), sign[0]);
}

TEST(KeyLayout, GermanAndFrenchLettersAreWhereTheyArePrinted) {
    EXPECT_EQ(key_on_layout('Y', "z"), 'Z');
    EXPECT_EQ(key_on_layout('Z', "y"), 'Y');
    EXPECT_EQ(key_on_layout('Q', "a"), 'A');
    EXPECT_EQ(key_on_layout('W', "z"), 'Z');
    EXPECT_EQ(key_on_layout(';', "m"), 'M');
    EXPECT_EQ(key_on_layout('M', ","), ',') << "or two keys would be M";
}

TEST(KeyLayout, DigitsAndBracketsArePlaces) {
    EXPECT_EQ(key_on_layout('1', "&"), '1') << "French: 1 needs Shift";
    EXPECT_EQ(key_on_layout('[', "\u00fc"), '[') << "German: [ needs AltGr";
    EXPECT_EQ(key_on_layout(']', "+"), ']');
    EXPECT_EQ(key_on_layout(kKeypad1, "1"), kKeypad1);
}

TEST(KeyLayout, WithoutALatinLetterAKeyIsItsPlace) {
    EXPECT_EQ(key_on_layout('Z', "\u044f"), 'Z');
    EXPECT_EQ(key_on_layout(kEscape, nullptr), kEscape);
    EXPECT_EQ(key_on_layout('Z', ""), 'Z');
    EXPECT_EQ(key_on_layout('Z', nullptr), 'Z');
}

}  // namespace
}  // namespace relievo::gui::key_layout_test
