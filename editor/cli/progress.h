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

    // `note`: what stands behind the bar; how many are done when empty.
    void update(std::size_t done, std::size_t total, const std::string& note = {});
    void say(const std::string& line);  // a line on stderr that stays, terminal or not
    void clear();

  private:
    std::string label_;
    bool terminal_, shown_ = false;
    std::chrono::steady_clock::time_point last_{};
};

}  // namespace relievo
