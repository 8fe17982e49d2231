// SPDX-License-Identifier: Apache-2.0
// The native engine of any profile behind one type; library horopter::native.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "stages/pipeline.hpp"

namespace horopter::native {

class Engine {
 public:
  virtual ~Engine() = default;
  virtual FrameResult process(const ImageView& left, const ImageView& right, const TableView& table,
                              const Settings& settings) = 0;
  /// Expands a table before a frame needs it, which takes as long as some frames. The last 15 tables are kept. `lookahead`:
  /// of the frames' settings. Throws std::invalid_argument for one that is larger than the profile.
  virtual void prepare(const TableView& table, int lookahead) = 0;
  /// Frames that had to wait until their table was expanded.
  [[nodiscard]] virtual int frames_that_expanded() const = 0;
  /// That share a frame.
  [[nodiscard]] virtual int threads() const = 0;
  [[nodiscard]] virtual const hls::Profile& profile() const = 0;
};

/// What the engine is compiled for. The results are the same, bit by bit.
enum class Instructions { baseline, avx2, avx512 };

std::string_view name_of(Instructions instructions);

/// Those that this build has and this processor too, the fastest last.
std::vector<Instructions> available_instructions();

/// Threads where the environment variable HOROPTER_THREADS does not say how many, 1 to 16.
enum Threads : int {
  threads_usual = 0,  ///< one
  threads_live = -1,  ///< two where there are two processors: for frames that do not wait
};

/// Null for a name that profiles.def does not have. An engine remembers the last frame only to find a frozen camera.
/// `threads`: that share a frame, or one of Threads. `instructions`: of those available; without, the one that the
/// environment variable HOROPTER_INSTRUCTIONS names (baseline, avx2, avx512), or else the fastest. Throws
/// std::invalid_argument for one that is not available.
std::unique_ptr<Engine> make_engine(std::string_view profile_name, int threads = threads_usual,
                                    std::optional<Instructions> instructions = std::nullopt);

}  // namespace horopter::native
