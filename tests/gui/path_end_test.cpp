// A path that has no room shows its end, where the file's name is.
#include <gtest/gtest.h>

#include "editor/gui/widgets.h"

namespace relievo::gui::path_end_test {
namespace {

float letters(std::string_view text) {  // each one wide, whatever bytes it takes
    float count = 0;
    for (const char byte : text) count += (static_cast<unsigned char>(byte) & 0xc0) == 0x80 ? 0.0f : 1.0f;
    return count;
}

TEST(PathEnd, IsWholeWhereItFitsAndElseKeepsTheName) {
    EXPECT_EQ(fitting_end("/maps/orb.exr", 13, letters), "/maps/orb.exr");
    EXPECT_EQ(fitting_end("/maps/orb.exr", 12, letters), "...s/orb.exr");
    EXPECT_EQ(fitting_end("/maps/orb.exr", 3, letters), "...");
    EXPECT_EQ(fitting_end("/maps/orb.exr", 0, letters), "...");
    EXPECT_EQ(fitting_end("", 0, letters), "");
}

TEST(PathEnd, CutsNoLetterInTwo) {
    const std::string path = "/b\xc3\xa4ume/\xe6\xa8\xb9.exr";  // 12 letters
    for (int room = 3; room < 12; ++room) {
        const std::string shown = fitting_end(path, static_cast<float>(room), letters);
        EXPECT_EQ(letters(shown), static_cast<float>(room)) << shown;
        EXPECT_TRUE(shown.size() < 4 || (shown[3] & 0xc0) != 0x80) << shown;
    }
}

}  // namespace
}  // namespace relievo::gui::path_end_test
