// Divides a dab's work among the processor's cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace relievo {

inline thread_local bool shares_work = false;  // this thread does part of a shared job already

// Calls work(i) once for each i in [0, count), in any order and on any thread, `most` at a time at most;
// returns when all are done, and throws what one of them threw. Within such a job, and one at a time, it is a
// plain loop; what is done one at a time may share its own parts.
template <typename Work>
void share_work(std::size_t count, const Work& work, std::size_t most = ~std::size_t{0}) {
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
    std::vector<std::future<void>> others;  // their destructors wait, also when this thread's part throws
    for (std::size_t i = 0; i < helpers; ++i) others.push_back(std::async(std::launch::async, do_some));
    do_some();
    for (std::future<void>& other : others) other.get();
}

}  // namespace relievo
