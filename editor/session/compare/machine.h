// The machine that times were taken on.
#pragma once

#include "editor/session/compare/result.h"

namespace relievo {

MachineInfo machine_info();

}  // namespace relievo
