// One declaration a method, for the registry.
#pragma once

#include "renderer/methods/registry.h"

namespace relievo {

extern const Method kExact;
extern const Method kPdm;

}  // namespace relievo
