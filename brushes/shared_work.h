// Divides a dab's work among the processor's cores.
#pragma once

#include <cstddef>
#include <functional>

namespace relievo {

inline thread_local bool shares_work = false;  // this thread does part of a shared job already

// Calls work(i) once for each i in [0, count), in any order and on any thread, `most` at a time at most;
// returns when all are done, and throws what one of them threw. Within such a job, and one at a time, it is a
// plain loop; what is done one at a time may share its own parts.
void share_work(std::size_t count, const std::function<void(std::size_t)>& work, std::size_t most = ~std::size_t{0});

}  // namespace relievo
