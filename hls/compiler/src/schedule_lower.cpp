// SPDX-License-Identifier: Apache-2.0
// Multiplications without a hard multiplier become sums of shifted operands, in a balanced tree, so that the schedule
// may cut them anywhere. Long chains of exclusive ors (a CRC, bit by bit) become one parity of their sources for each
// bit, in which equal sources cancel.
#include <algorithm>
#include <iterator>
#include <map>

#include "hlsc/schedule.hpp"

namespace hlsc {

namespace {

class Lowering {
 public:
  Lowering(const Graph& graph, const ScheduleOptions& options) : in_(graph), options_(options) {}

  Graph run() {
    find_parities();
    const bool any = std::ranges::any_of(in_.nodes, [&](const Node& node) { return wanted(node); });
    if (!any && parities_.empty()) return in_;
    out_ = in_;
    out_.nodes.clear();
    map_.resize(in_.nodes.size());
    for (NodeId n = 0; n < in_.nodes.size(); ++n) {
      const Node& node = in_.nodes[n];
      if (wanted(node)) {
        map_[n] = multiply(node);
        continue;
      }
      Node copy = node;
      for (Bits& operand : copy.operands) operand = mapped(operand);
      map_[n] = append(std::move(copy));
      for (std::uint32_t i = 0; i < node.width; ++i) {
        const auto it = parities_.find({n, i});
        if (it == parities_.end()) continue;
        Node parity;
        parity.op = Op::kReduceXor;
        parity.operands = {mapped(it->second)};
        parity.where = node.where;
        parity.name = node.name;
        map_[n][i] = append(std::move(parity))[0];
      }
    }
    const auto node_of = [&](NodeId n) { return map_[n].at(0).node; };
    for (Port& p : out_.inputs) p.node = node_of(p.node);
    for (Port& p : out_.configs) p.node = node_of(p.node);
    for (Port& p : out_.outputs) p.value = mapped(p.value);
    for (State& s : out_.states) {
      s.read = node_of(s.read);
      s.next = mapped(s.next);
    }
    for (Ram& r : out_.rams) {
      if (r.read != 0) r.read = node_of(r.read);
      r.read_address = mapped(r.read_address);
      r.write_address = mapped(r.write_address);
      r.write_data = mapped(r.write_data);
      r.read_enable = mapped({r.read_enable}).at(0);
      r.write_enable = mapped({r.write_enable}).at(0);
    }
    out_.output_valid = mapped({out_.output_valid}).at(0);
    return std::move(out_);
  }

 private:
  static std::uint32_t constant_bits(const Bits& bits) {
    return static_cast<std::uint32_t>(std::ranges::count_if(bits, [](Bit b) { return b.node == 0; }));
  }
  static bool is_constant(const Bits& bits) { return constant_bits(bits) == bits.size(); }

  bool wanted(const Node& node) const {
    if (node.op != Op::kMul && node.op != Op::kMulSigned) return false;
    const auto& model = options_.delays;
    if (is_constant(node.operands[0]) || is_constant(node.operands[1])) return true;
    const auto widest = std::max(variable_bits(node.operands[0]), variable_bits(node.operands[1]));
    return model.multiplier_bits == 0 || widest > model.multiplier_bits ||
           std::min(variable_bits(node.operands[0]), variable_bits(node.operands[1])) <= 3;
  }

  /// The exclusive ors whose chain is deeper than the tree of their sources. The chain itself stays in the graph and
  /// dies, unless something needs a bit of it that is not deep.
  void find_parities() {
    constexpr std::size_t kLargest = 32;
    struct Tree {
      Bits sources;  ///< sorted, each once
      unsigned depth = 0;
    };
    std::map<Bit, Tree> trees;
    for (NodeId n = 1; n < in_.nodes.size(); ++n) {
      const Node& node = in_.nodes[n];
      if (node.op != Op::kXor) continue;
      for (std::uint32_t i = 0; i < node.width; ++i) {
        const auto tree_of = [&](Bit b) {
          const auto it = trees.find(b);
          return it != trees.end() ? it->second : Tree{{b}, 0};
        };
        const Tree a = tree_of(node.operands[0][i]), b = tree_of(node.operands[1][i]);
        Tree tree;
        std::ranges::set_symmetric_difference(a.sources, b.sources, std::back_inserter(tree.sources));
        tree.depth = std::max(a.depth, b.depth) + 1;
        if (tree.sources.size() > kLargest || tree.sources.empty()) continue;  // a source of what comes after
        // As delay.cpp has it: 0.55 levels for each exclusive or; a tree of LUT4.
        double levels = 1.0;
        for (std::size_t inputs = tree.sources.size(); inputs > 4; inputs = (inputs + 3) / 4) ++levels;
        if (0.55 * tree.depth > levels) parities_[{n, i}] = tree.sources;
        trees[{n, i}] = std::move(tree);
      }
    }
    // A source may itself be a parity: sources are bits of the graph before, and mapped() finds what they became.
  }

  /// Bits that carry information: constants and repetitions of the sign do not count.
  static std::uint32_t variable_bits(const Bits& bits) {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < bits.size(); ++i) {
      if (bits[i].node != 0 && (i == 0 || bits[i] != bits[i - 1])) ++count;
    }
    return count;
  }

  Bits append(Node node) {
    const auto id = static_cast<NodeId>(out_.nodes.size());
    const auto width = node.op == Op::kConstant ? 2U : node.width;
    out_.nodes.push_back(std::move(node));
    Bits bits;
    for (std::uint32_t i = 0; i < width; ++i) bits.push_back({id, i});
    return bits;
  }

  Bits mapped(const Bits& bits) const {
    Bits result;
    result.reserve(bits.size());
    for (Bit b : bits) result.push_back(map_[b.node].at(b.index));
    return result;
  }

  /// A summand: bits placed at a weight; the sum of all is taken modulo 2^width.
  struct Term {
    Bits bits;              ///< of full width
    bool negative = false;  ///< to be subtracted
  };

  Bits multiply(const Node& node) {
    const std::uint32_t width = node.width;
    const bool with_sign = node.op == Op::kMulSigned;
    const auto extend = [&](const Bits& operand) {
      Bits bits = mapped(operand);
      bits.resize(width, with_sign && !bits.empty() ? bits.back() : kZero);
      return bits;
    };
    Bits a = extend(node.operands[0]), b = extend(node.operands[1]);
    // b selects the rows: the constant, or the one with fewer distinct bits.
    if (!is_constant(b) && (is_constant(a) || variable_bits(a) < variable_bits(b))) std::swap(a, b);
    std::vector<Term> terms;
    const auto shifted = [&](std::uint32_t by) {
      Bits bits(by, kZero);
      bits.insert(bits.end(), a.begin(), a.end());
      bits.resize(width);
      return bits;
    };
    if (is_constant(b)) {
      // Canonical signed digits: as few summands as possible.
      int carry = 0;
      for (std::uint32_t i = 0; i < width; ++i) {
        const int bit = static_cast<int>(b[i].index) + carry;
        const int next = i + 1 < width ? static_cast<int>(b[i + 1].index) : 0;
        carry = 0;
        if (bit == 2) {
          carry = 1;
        } else if (bit == 1) {
          if (next == 1) {
            terms.push_back({shifted(i), true});
            carry = 1;
          } else {
            terms.push_back({shifted(i), false});
          }
        }
      }
    } else {
      // A run of equal bits at the top is the sign, of negative weight.
      std::uint32_t rows = width;
      while (rows > 1 && b[rows - 1] == b[rows - 2]) --rows;
      const bool sign_row = rows < width;
      for (std::uint32_t i = 0; i < rows; ++i) {
        if (b[i] == kZero) continue;
        Bits row = shifted(i);
        if (b[i] != kOne) row = gate(row, b[i], node);
        terms.push_back({row, sign_row && i + 1 == rows});
      }
    }
    if (terms.empty()) return Bits(width, kZero);
    // Rows of equal depth in pairs, in order, so that neighbours, which overlap most, meet.
    while (terms.size() > 1) {
      std::vector<Term> sums;
      for (std::size_t i = 0; i + 1 < terms.size(); i += 2) sums.push_back(add(terms[i], terms[i + 1], node));
      if (terms.size() % 2 == 1) sums.push_back(terms.back());
      terms = std::move(sums);
    }
    if (terms[0].negative) return operation(Op::kSub, Bits(width, kZero), terms[0].bits, node);
    return terms[0].bits;
  }

  /// Every bit of `row` AND `enable`; equal bits share a gate.
  Bits gate(const Bits& row, Bit enable, const Node& origin) {
    Bits distinct;
    std::map<Bit, std::size_t> index;
    for (Bit b : row) {
      if (b.node != 0 && index.try_emplace(b, distinct.size()).second) distinct.push_back(b);
      if (b == kOne && index.try_emplace(b, distinct.size()).second) distinct.push_back(b);
    }
    if (distinct.empty()) return row;
    Node node;
    node.op = Op::kAnd;
    node.width = static_cast<std::uint32_t>(distinct.size());
    node.operands = {distinct, Bits(distinct.size(), enable)};
    node.where = origin.where;
    const Bits gated = append(std::move(node));
    Bits result;
    for (Bit b : row) result.push_back(b == kZero ? kZero : gated[index.at(b)]);
    return result;
  }

  Bits operation(Op op, const Bits& a, const Bits& b, const Node& origin) {
    Node node;
    node.op = op;
    node.width = static_cast<std::uint32_t>(a.size());
    node.operands = {a, b};
    node.where = origin.where;
    node.name = origin.name;
    return append(std::move(node));
  }

  /// The low bits where one summand is zero pass through; above both, an unsigned sum needs one bit of carry only.
  Term add(const Term& x, const Term& y, const Node& origin) {
    const std::uint32_t width = static_cast<std::uint32_t>(x.bits.size());
    if (x.negative && !y.negative) return add(y, x, origin);
    const bool subtract = x.negative != y.negative;
    std::uint32_t low = 0;
    while (low < width && (y.bits[low] == kZero || (!subtract && x.bits[low] == kZero))) ++low;
    std::uint32_t high = width;
    if (!subtract) {
      std::uint32_t top = width;
      while (top > 0 && x.bits[top - 1] == kZero && y.bits[top - 1] == kZero) --top;
      high = std::min(width, top + 1);
    }
    if (low >= high) {
      Term result = x;
      for (std::uint32_t i = 0; i < width && !subtract; ++i) {
        if (x.bits[i] == kZero) result.bits[i] = y.bits[i];
      }
      return result;
    }
    // Equal sign bits at the top of both: one more bit holds the sum, and it repeats.
    std::uint32_t run = high;
    while (run > low + 1 && x.bits[run - 1] == x.bits[run - 2] && y.bits[run - 1] == y.bits[run - 2]) --run;
    std::uint32_t computed = std::min(high, run + 1);
    const Bits xs(x.bits.begin() + low, x.bits.begin() + computed), ys(y.bits.begin() + low, y.bits.begin() + computed);
    const Bits sum = operation(subtract ? Op::kSub : Op::kAdd, xs, ys, origin);
    Term result;
    result.negative = x.negative && y.negative;
    for (std::uint32_t i = 0; i < width; ++i) {
      if (i < low) {
        result.bits.push_back(subtract || y.bits[i] == kZero ? x.bits[i] : y.bits[i]);
      } else if (i < computed) {
        result.bits.push_back(sum[i - low]);
      } else {
        result.bits.push_back(i < high ? sum.back() : kZero);
      }
    }
    return result;
  }

  const Graph& in_;
  const ScheduleOptions& options_;
  Graph out_;
  std::vector<Bits> map_;
  std::map<Bit, Bits> parities_;
};

}  // namespace

Graph lower_for_target(const Graph& graph, const ScheduleOptions& options) { return Lowering(graph, options).run(); }

}  // namespace hlsc
