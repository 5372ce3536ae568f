// A bar on stderr for long work, when stderr is a terminal; nothing otherwise.
#include "editor/cli/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace relievo {
namespace {

// A longer line would wrap, and could not be taken back.
std::size_t terminal_columns() {
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    return known ? size.ws_col : 120;
}

}  // namespace

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
    clear();
}

void ProgressBar::clear() {
    if (shown_) std::fputs("\r\033[K", stderr);
    shown_ = false;
}

void ProgressBar::say(const std::string& line) {
    clear();
    std::fprintf(stderr, "%s\n", line.c_str());
}

void ProgressBar::update(std::size_t done, std::size_t total, const std::string& note) {
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ || total == 0 || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    shown_ = true;
    constexpr std::size_t kCells = 30;
    const std::size_t filled = done * kCells / total;
    const std::string bar = std::string(filled, '#') + std::string(kCells - filled, '.');
    const std::string behind = note.empty() ? std::to_string(done) + " of " + std::to_string(total) : note;
    const std::string line = label_ + " [" + bar + "] " + behind;
    std::fprintf(stderr, "\r%s\033[K", line.substr(0, terminal_columns() - 1).c_str());
    std::fflush(stderr);
}

}  // namespace relievo
