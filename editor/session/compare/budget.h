// The time that a comparison may take, and what of it one scene may.
#pragma once

#include <chrono>
#include <limits>

namespace relievo {

class Budget {
  public:
    using Clock = std::chrono::steady_clock;

    explicit Budget(double seconds)
        : limit_(seconds > 0 ? seconds : std::numeric_limits<double>::infinity()) {}

    double spent() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    double left() const { return limit_ - spent(); }
    // An equal share of what is left, for the next of `scenes` scenes; some is kept back for the report.
    Budget share(int scenes) const {
        constexpr double kKept = 0.95;
        const double seconds = left() * kKept / scenes;
        return seconds > 0 ? Budget(seconds) : Budget(1e-9);
    }
    bool endless() const { return limit_ == std::numeric_limits<double>::infinity(); }
    double limit() const { return limit_; }

  private:
    double limit_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace relievo
