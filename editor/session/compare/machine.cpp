// See machine.h.
#include "editor/session/compare/machine.h"

#include <sys/utsname.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace relievo {
namespace {

std::string cpu_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("model name")) continue;
        const auto colon = line.find(": ");
        if (colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

}  // namespace

MachineInfo machine_info() {
    MachineInfo info;
    info.cpu = cpu_name();
    info.cores = static_cast<int>(std::thread::hardware_concurrency());
    utsname system{};
    if (uname(&system) == 0) info.system = std::string(system.sysname) + " " + system.machine;
    double load = 0;
    if (getloadavg(&load, 1) == 1) info.load = load;
    return info;
}

}  // namespace relievo
