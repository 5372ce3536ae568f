// Which state of map, colours or mask, or of all, is there and which was saved: every step makes one of its own.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace relievo {

class Steps {
  public:
    // `changes_it`: false for a step of something else.
    void add(bool changes_it = true) {
        done_.push_back(changes_it ? ++newest_ : current());
        undone_.clear();
    }
    void undo() { move_last(done_, undone_); }
    void redo() { move_last(undone_, done_); }
    void mark_saved() { saved_ = current(); }

    bool unsaved() const { return current() != saved_; }
    bool saved_is_ahead() const { return contains(undone_, saved_); }
    bool saved_is_behind() const { return saved_ == 0 || contains(done_, saved_); }
    // How many undos, or redos, lead there.
    std::size_t steps_to_saved() const {
        const auto& way = saved_is_ahead() ? undone_ : done_;
        const auto at = std::find(way.rbegin(), way.rend(), saved_);
        return static_cast<std::size_t>(at - way.rbegin()) + (saved_is_ahead() ? 1 : 0);
    }

  private:
    std::uint64_t current() const { return done_.empty() ? 0 : done_.back(); }
    static bool contains(const std::vector<std::uint64_t>& states, std::uint64_t state) {
        return std::find(states.begin(), states.end(), state) != states.end();
    }
    static void move_last(std::vector<std::uint64_t>& from, std::vector<std::uint64_t>& to) {
        if (from.empty()) return;
        to.push_back(from.back());
        from.pop_back();
    }

    std::vector<std::uint64_t> done_, undone_;  // states by number; 0 is what was loaded
    std::uint64_t newest_ = 0, saved_ = 0;
};

}  // namespace relievo
