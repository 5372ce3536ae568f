// Loaded before libXi (LD_PRELOAD), makes a pen of every pointing device: its axis 1, which Xvfb's pointer
// moves down the screen, is said to be the pressure, from 0 at the top to 1 at RELIEVO_PEN_FULL pixels. With
// RELIEVO_PEN_ERASER the device has the name of an eraser.
#include <X11/extensions/XInput2.h>
#include <dlfcn.h>

#include <cstdlib>
#include <cstring>

extern "C" XIDeviceInfo* XIQueryDevice(Display* display, int device, int* count) {
    using Query = XIDeviceInfo* (*)(Display*, int, int*);
    XIDeviceInfo* infos = reinterpret_cast<Query>(dlsym(RTLD_NEXT, "XIQueryDevice"))(display, device, count);
    const char* full = std::getenv("RELIEVO_PEN_FULL");
    if (infos == nullptr || full == nullptr) return infos;
    for (XIDeviceInfo* info = infos; info != infos + *count; ++info) {
        if (info->use != XISlavePointer) continue;
        // In its place: the name is freed with the rest, and "XTEST pointer" is long enough.
        if (std::getenv("RELIEVO_PEN_ERASER") && std::strlen(info->name) >= 6)
            std::strcpy(info->name, "Eraser");
        for (int i = 0; i < info->num_classes; ++i) {
            if (info->classes[i]->type != XIValuatorClass) continue;
            auto* axis = reinterpret_cast<XIValuatorClassInfo*>(info->classes[i]);
            if (axis->number != 1) continue;
            axis->label = XInternAtom(display, "Abs Pressure", False);
            axis->min = 0;
            axis->max = std::atof(full);
        }
    }
    return infos;
}
