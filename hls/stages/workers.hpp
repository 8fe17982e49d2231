// SPDX-License-Identifier: Apache-2.0
// The threads of a native engine, which wait between frames.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace horopter::native {

class Workers {
 public:
  /// `threads`: with that of the caller.
  explicit Workers(int threads) {
    for (int i = 1; i < threads; ++i) {
      others_.emplace_back([this, i] { wait(i); });
    }
  }
  ~Workers() {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    changed_.notify_all();
    for (std::thread& other : others_) other.join();
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  [[nodiscard]] int count() const { return static_cast<int>(others_.size()) + 1; }

  /// Calls `work`, which throws nothing, once in each thread with its number, and returns when all have returned.
  void run(const std::function<void(int)>& work) {
    {
      const std::lock_guard lock(mutex_);
      work_ = &work;
      at_work_ = count() - 1;
      ++round_;
    }
    changed_.notify_all();
    work(0);
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return at_work_ == 0; });
  }

 private:
  void wait(int number) {
    unsigned passed = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [&] { return ends_ || round_ != passed; });
      if (ends_) return;
      passed = round_;
      const auto* const work = work_;
      lock.unlock();
      (*work)(number);
      lock.lock();
      if (--at_work_ == 0) changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<void(int)>* work_ = nullptr;
  int at_work_ = 0;
  unsigned round_ = 0;
  bool ends_ = false;
  std::vector<std::thread> others_;
};

}  // namespace horopter::native
