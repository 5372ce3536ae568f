// A bar on stderr for long work, when stderr is a terminal; nothing otherwise.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace relievo {

class ProgressBar {
  public:
    explicit ProgressBar(std::string label);
    ~ProgressBar();  // clears the line
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void update(std::size_t done, std::size_t total);

  private:
    std::string label_;
    bool terminal_, shown_ = false;
    std::chrono::steady_clock::time_point last_{};
};

}  // namespace relievo
