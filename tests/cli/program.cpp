// Runs the program as a user does, and keeps what it said.
#include "tests/cli/program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/session/test_scene.h"

namespace relievo::test {
namespace {

[[noreturn]] void become_program(const std::vector<std::string>& arguments, const Surroundings& surroundings,
                                 const std::filesystem::path& out, const std::filesystem::path& err) {
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    for (const auto& [name, value] : surroundings.environment) setenv(name.c_str(), value.c_str(), 1);
    if (surroundings.file_size_limit > 0) {
        const rlimit limit{surroundings.file_size_limit, surroundings.file_size_limit};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    std::string program = RELIEVO_PROGRAM;
    std::vector<std::string> words = arguments;
    std::vector<char*> pointers{program.data()};
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    execv(program.c_str(), pointers.data());
    _exit(127);
}

}  // namespace

Outcome run_program(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
    const TemporaryFolder folder;
    const pid_t child = fork();
    if (child == 0) become_program(arguments, surroundings, folder.path() / "out", folder.path() / "err");
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            read_text(folder.path() / "out"), read_text(folder.path() / "err")};
}

Surroundings without_vulkan() {
    return {{{"VK_DRIVER_FILES", "/nonexistent.json"}, {"VK_ICD_FILENAMES", "/nonexistent.json"}}, 0};
}

bool have_device() {
    static const bool have =
        run_program({"devices", "--json"}).out.find("\"used\": true") != std::string::npos;
    return have;
}

}  // namespace relievo::test
