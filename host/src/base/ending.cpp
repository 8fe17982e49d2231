// SPDX-License-Identifier: Apache-2.0
#include "horopter/base/ending.hpp"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace horopter {
namespace {

struct Registry {
  std::mutex mutex;
  std::vector<std::function<void()>*> actions;
};

/// Never destroyed: a signal may come while the program ends.
Registry& registry() {
  static auto* const the_one = new Registry;
  return *the_one;
}

}  // namespace

BeforeEnding::BeforeEnding(std::function<void()> action) : action_(std::move(action)) {
  const std::lock_guard lock(registry().mutex);
  registry().actions.push_back(&action_);
}

BeforeEnding::~BeforeEnding() {
  const std::lock_guard lock(registry().mutex);
  std::erase(registry().actions, &action_);
}

void prepare_ending() {
  registry().mutex.lock();
  const auto& actions = registry().actions;
  std::for_each(actions.rbegin(), actions.rend(), [](const auto* action) { (*action)(); });
}

void ending_by_itself() { registry().mutex.lock(); }

}  // namespace horopter
