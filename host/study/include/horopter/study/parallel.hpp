// SPDX-License-Identifier: Apache-2.0
// Independent pieces of work on all processors. Results belong to the index, so they do not depend on the order.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace horopter::study {

/// Calls work(i) once for every i < count. `done(n)` is called from this thread's share after n pieces at least. The
/// first exception ends the work and is thrown again.
template <class Work, class Done>
void parallel_for(std::size_t count, Work work, Done done) {
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> finished{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&](bool reports) {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
      ++finished;
      if (reports) done(finished.load());
    }
  };
  const auto processors = static_cast<std::size_t>(std::max(1U, std::thread::hardware_concurrency()));
  std::vector<std::thread> threads;
  for (std::size_t i = 1; i < std::min(count, processors); ++i) threads.emplace_back(run, false);
  run(true);
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

template <class Work>
void parallel_for(std::size_t count, Work work) {
  parallel_for(count, work, [](std::size_t) {});
}

}  // namespace horopter::study
