// A bar on stderr for long work, when stderr is a terminal; nothing otherwise.
#include "editor/cli/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace relievo {

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::update(std::size_t done, std::size_t total) {
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ || total == 0 || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    shown_ = true;
    constexpr std::size_t kCells = 30;
    const std::size_t filled = done * kCells / total;
    const std::string bar = std::string(filled, '#') + std::string(kCells - filled, '.');
    std::fprintf(stderr, "\r%s [%s] %zu of %zu\033[K", label_.c_str(), bar.c_str(), done, total);
    std::fflush(stderr);
}

}  // namespace relievo
