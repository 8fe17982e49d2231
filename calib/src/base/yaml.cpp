// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/yaml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/eventhandler.h>

#include <cmath>
#include <map>
#include <sstream>

#include "horopter/calib/error.hpp"

namespace horopter::calib::yaml {
namespace {

std::string line_and_column(const YAML::Mark& mark) {
  return mark.is_null() ? "" : fmt::format("line {}, column {}", mark.line + 1, mark.column + 1);
}

std::string describe(const YAML::Node& node) {
  if (!node.IsDefined() || node.IsNull()) return "nothing";
  if (node.IsScalar()) return "'" + node.Scalar() + "'";
  return node.IsMap() ? "a map" : fmt::format("a list of {}", node.size());
}

/// What a reader of nodes would take without a word, leave out, or never end with: a key that stands twice in a map, a
/// second document, a part that contains itself, aliases of aliases that stand for more than any file holds, and nesting
/// without end.
class Guard final : public YAML::EventHandler {
 public:
  Guard(const std::string& file, const std::string& expected) : file_{file}, expected_{expected} {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ > 0) throw FileError(file_, line_and_column(mark), "a second document", "one");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { scalar(mark, anchor, ""); }
  void OnScalar(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                const std::string& value) override {
    scalar(mark, anchor, value);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    for (const Open& part : open_) {
      if (part.anchor == anchor) fail(mark, "an alias of what it stands in");
    }
    const std::size_t nodes = nodes_[anchor];
    aliased_ += nodes;
    if (aliased_ > kMostAliased) fail(mark, "aliases that stand for too much");
    end_of_child(nodes);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    start(mark, anchor, false);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    start(mark, anchor, true);
  }
  void OnMapEnd() override { end(); }

 private:
  static constexpr std::size_t kMostAliased = 100'000;
  static constexpr std::size_t kDeepest = 64;
  struct Open {
    YAML::anchor_t anchor = 0;
    bool map = false, at_key = true;
    std::set<std::string> keys{};
    std::size_t nodes = 1;
  };

  void scalar(const YAML::Mark& mark, YAML::anchor_t anchor, const std::string& value) {
    if (!open_.empty() && open_.back().map && open_.back().at_key && !open_.back().keys.insert(value).second) {
      fail(mark, fmt::format("the key '{}' a second time", value));
    }
    if (anchor != 0) nodes_[anchor] = 1;
    end_of_child(1);
  }
  void start(const YAML::Mark& mark, YAML::anchor_t anchor, bool map) {
    if (open_.size() == kDeepest) fail(mark, fmt::format("more than {} lists and maps in each other", kDeepest));
    open_.push_back({.anchor = anchor, .map = map});
  }
  void end() {
    const Open ended = std::move(open_.back());
    open_.pop_back();
    if (ended.anchor != 0) nodes_[ended.anchor] = ended.nodes;
    end_of_child(ended.nodes);
  }
  void end_of_child(std::size_t nodes) {
    if (open_.empty()) return;
    open_.back().nodes += nodes;
    open_.back().at_key = !open_.back().at_key;
  }
  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& found) const {
    throw FileError(file_, line_and_column(mark), found, expected_);
  }

  const std::string& file_;
  const std::string& expected_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, std::size_t> nodes_;  ///< in what an anchor names, aliases included
  std::size_t aliased_ = 0;
  int documents_ = 0;
};

void append_numbers(std::vector<double>& values, const std::string& file, const YAML::Node& node,
                    const std::string& what) {
  if (!node.IsSequence()) {
    values.push_back(number(file, node, what));
    return;
  }
  for (const YAML::Node& inner : node) append_numbers(values, file, inner, what);
}

}  // namespace

YAML::Node parse(const std::string& file, const std::string& text, const std::string& expected) {
  try {
    std::istringstream stream(text);
    Guard guard(file, expected);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(guard)) continue;
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw FileError(file, line_and_column(error.mark), "not YAML (" + error.msg + ")", expected);
  }
}

std::string place(const YAML::Node& node, const std::string& what) {
  const std::string where = line_and_column(node.Mark());
  return where.empty() || what.empty() ? where + what : where + ": " + what;
}

void fail(const std::string& file, const YAML::Node& node, const std::string& what, const std::string& found,
          const std::string& expected) {
  throw FileError(file, place(node, what), found.empty() ? describe(node) : found, expected);
}

YAML::Node member(const std::string& file, const YAML::Node& map, const std::string& key, const std::string& expected) {
  if (!map.IsMap()) fail(file, map, key, "its parent is not a map", expected);
  const YAML::Node node = map[key];
  if (!node.IsDefined() || node.IsNull()) fail(file, map, key, "missing", expected);
  return node;
}

double number(const std::string& file, const YAML::Node& node, const std::string& what) {
  double value = NAN;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    fail(file, node, what, "", "a finite number");
  }
  return value;
}

std::vector<double> numbers(const std::string& file, const YAML::Node& node, const std::string& what,
                            std::size_t count) {
  const std::string expected = count > 0 ? fmt::format("{} numbers", count) : "numbers";
  if (!node.IsSequence()) fail(file, node, what, "", "a list of " + expected);
  std::vector<double> values;
  append_numbers(values, file, node, what);
  if (count > 0 && values.size() != count) {
    fail(file, node, what, fmt::format("{} numbers", values.size()), expected);
  }
  return values;
}

void check_keys(const std::string& file, const YAML::Node& map, const std::set<std::string>& known,
                const std::string& what) {
  if (!map.IsMap()) fail(file, map, what, "", "a map");
  for (const auto& item : map) {
    const std::string key = item.first.IsScalar() ? item.first.Scalar() : "?";
    if (known.contains(key)) continue;
    fail(file, item.first, what, "'" + key + "' is not known", fmt::format("{}", fmt::join(known, ", ")));
  }
}

}  // namespace horopter::calib::yaml
