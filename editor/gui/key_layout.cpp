// See key_layout.h.
#include "editor/gui/key_layout.h"

namespace relievo::gui {

int key_on_layout(int key, const char* name) {
    const bool one_sign = name && name[0] > ' ' && name[0] < 127 && name[1] == '\0';
    if (!one_sign) return key;
    const char sign = name[0];
    if (sign >= 'a' && sign <= 'z') return sign - 'a' + 'A';
    if (sign >= 'A' && sign <= 'Z') return sign;
    return key >= 'A' && key <= 'Z' ? sign : key;
}

}  // namespace relievo::gui
