// The list of methods: one line each, the first is the default. Everything else follows from it.
#pragma once

#include "renderer/methods/registry.h"

#define RELIEVO_METHODS(METHOD) \
    METHOD(kExact)              \
    METHOD(kPdm)                \
    METHOD(kDbvh)               \
    METHOD(kMarch)              \
    METHOD(kTessellated)

namespace relievo {

#define RELIEVO_DECLARE(method) extern const Method method;
RELIEVO_METHODS(RELIEVO_DECLARE)
#undef RELIEVO_DECLARE

}  // namespace relievo
