// Runs the program as a user does, and keeps what it said.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace relievo::test {

struct Outcome {
    int status = -1;  // exit status; 128 + signal when it was killed
    std::string out, err;
};

struct Surroundings {
    std::vector<std::pair<std::string, std::string>> environment;  // added to the test's own
    std::size_t file_size_limit = 0;                               // bytes; 0: none
};

Outcome run_program(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});

// No Vulkan driver at all.
Surroundings without_vulkan();
bool have_device();

}  // namespace relievo::test
