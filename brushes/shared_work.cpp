// By the threads of oneTBB, which wait between dabs: to start one takes as long as a small dab's share.
#include "brushes/shared_work.h"

#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <thread>

namespace relievo {

void share_work(std::size_t count, const std::function<void(std::size_t)>& work, std::size_t most) {
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t helpers = std::min({cores, count, most}) - (count > 0 && most > 0 ? 1 : 0);
    if (shares_work || helpers == 0) {
        for (std::size_t i = 0; i < count; ++i) work(i);
        return;
    }
    std::atomic<std::size_t> next{0};
    const auto do_some = [&] {
        struct Restore {
            ~Restore() { shares_work = false; }
        } restore;
        shares_work = true;
        for (std::size_t i = next++; i < count; i = next++) work(i);
    };
    tbb::task_group group;
    for (std::size_t i = 0; i < helpers; ++i) group.run(do_some);
    group.run_and_wait(do_some);
}

}  // namespace relievo
