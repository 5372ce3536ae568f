// Which key a press means on the keyboard's own layout.
#pragma once

namespace relievo::gui {

// GLFW numbers keys by their places on an American keyboard, in ASCII where something is printed there. What
// is returned is the number of the letter that is printed on this one: Ctrl + Z undoes on German and French
// keyboards too, where the letter lies elsewhere. A letter's place that has a sign gives that sign. All other
// keys stay places: digits and brackets may need Shift or AltGr here, and other alphabets have no Latin
// letters. `name`: what the key alone types, as glfwGetKeyName() says; null where that is nothing.
int key_on_layout(int key, const char* name);

}  // namespace relievo::gui
