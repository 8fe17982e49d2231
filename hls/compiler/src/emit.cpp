// SPDX-License-Identifier: Apache-2.0
#include "hlsc/emit.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

namespace hlsc {

namespace {

constexpr std::array kReservedWords = std::to_array<std::string_view>(
    {"accept_on",   "alias",         "always",    "and",       "assert",     "assign",     "assume",
     "automatic",   "before",        "begin",     "bind",      "bins",       "bit",        "break",
     "buf",         "byte",          "case",      "casex",     "casez",      "cell",       "chandle",
     "checker",     "class",         "clocking",  "config",    "const",      "constraint", "context",
     "continue",    "cover",         "cross",     "deassign",  "default",    "defparam",   "design",
     "disable",     "dist",          "do",        "edge",      "else",       "end",        "endcase",
     "enum",        "event",         "expect",    "export",    "extends",    "extern",     "final",
     "first_match", "for",           "force",     "foreach",   "forever",    "fork",       "function",
     "generate",    "genvar",        "global",    "if",        "iff",        "implements", "implies",
     "import",      "incdir",        "include",   "initial",   "inout",      "input",      "inside",
     "instance",    "int",           "integer",   "interface", "intersect",  "join",       "large",
     "let",         "liblist",       "library",   "local",     "localparam", "logic",      "longint",
     "macromodule", "matches",       "medium",    "modport",   "module",     "nand",       "negedge",
     "new",         "nor",           "not",       "null",      "or",         "output",     "package",
     "packed",      "parameter",     "posedge",   "primitive", "priority",   "program",    "property",
     "protected",   "pull0",         "pull1",     "pure",      "rand",       "real",       "realtime",
     "ref",         "reg",           "release",   "repeat",    "restrict",   "return",     "scalared",
     "sequence",    "shortint",      "shortreal", "signed",    "small",      "soft",       "solve",
     "specify",     "specparam",     "static",    "string",    "strong",     "struct",     "super",
     "supply0",     "supply1",       "table",     "tagged",    "task",       "this",       "throughout",
     "time",        "timeprecision", "timeunit",  "tran",      "tri",        "type",       "typedef",
     "union",       "unique",        "unique0",   "unsigned",  "until",      "untyped",    "use",
     "var",         "vectored",      "virtual",   "void",      "wait",       "wand",       "weak",
     "while",       "wildcard",      "wire",      "with",      "within",     "wor",        "xnor",
     "xor"});

std::string sanitise(std::string_view raw) {
  std::string name;
  for (char c : raw) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty()) name = "value";
  if (std::isdigit(static_cast<unsigned char>(name.front())) != 0) name.insert(0, "n");
  if (std::ranges::find(kReservedWords, std::string_view(name)) != kReservedWords.end()) name += "_v";
  return name;
}

std::string_view mnemonic(Op op) {
  switch (op) {
    case Op::kRom:
      return "table";
    case Op::kAnd:
      return "and";
    case Op::kOr:
      return "or";
    case Op::kXor:
      return "xor";
    case Op::kNot:
      return "not";
    case Op::kAdd:
      return "sum";
    case Op::kSub:
      return "difference";
    case Op::kMul:
    case Op::kMulSigned:
      return "product";
    case Op::kShl:
    case Op::kLshr:
    case Op::kAshr:
      return "shifted";
    case Op::kEq:
      return "equal";
    case Op::kUlt:
    case Op::kSlt:
      return "less";
    case Op::kMux:
      return "select";
    case Op::kReduceOr:
      return "any";
    case Op::kReduceAnd:
      return "all";
    case Op::kReduceXor:
      return "parity";
    default:
      return "value";
  }
}

std::uint32_t address_bits(std::uint64_t depth) {
  std::uint32_t bits = 1;
  while ((std::uint64_t{1} << bits) < depth) ++bits;
  return bits;
}

std::string range(std::uint32_t width) { return width == 1 ? "" : "[" + std::to_string(width - 1) + ":0] "; }

std::string literal(const std::vector<bool>& bits_lsb_first) {
  const auto width = bits_lsb_first.size();
  if (width == 1) return bits_lsb_first[0] ? "1'b1" : "1'b0";
  std::string digits;
  for (std::size_t low = 0; low < width; low += 4) {
    unsigned digit = 0;
    for (std::size_t i = 0; i < 4 && low + i < width; ++i) digit |= static_cast<unsigned>(bits_lsb_first[low + i]) << i;
    digits.insert(digits.begin(), "0123456789abcdef"[digit]);
  }
  const auto first = digits.find_first_not_of('0');
  digits = first == std::string::npos ? "0" : digits.substr(first);
  return std::to_string(width) + "'h" + digits;
}

class Emitter {
 public:
  /// `may_inline`: nodes to be written inside the expression that uses them; empty: none.
  Emitter(const Graph& graph, const Schedule& schedule, const EmitOptions& options, std::vector<bool> may_inline)
      : g_(graph),
        s_(schedule),
        o_(options),
        last_(schedule.latency),
        registered_(registered_outputs(schedule.options)),
        may_inline_(std::move(may_inline)) {}

  /// After run(): unnamed nodes that are used once and as a whole.
  std::vector<bool> used_once() const {
    std::vector<bool> result(g_.nodes.size(), false);
    for (NodeId n = 1; n < g_.nodes.size(); ++n) {
      if (node_signal_[n] == kNoSignal || s_.stage[n] == kDead || !g_.nodes[n].name.empty()) continue;
      const Signal& s = signals_[node_signal_[n]];
      result[n] = inlinable(g_.nodes[n].op) && s.uses == 1 && s.whole_uses == 1;
    }
    return result;
  }

  EmittedModule run() {
    declare_ports();
    name_nodes();
    find_shared_registers();
    find_registers();
    std::ostringstream body;
    emit_valid(body);
    emit_static(body);
    for (int stage = 0; stage <= last_; ++stage) emit_stage(body, stage);
    emit_valid_registers(body);
    emit_unused(body);
    std::ostringstream text;
    emit_header(text);
    text << body.str() << "\nendmodule\n";
    result_.text = text.str();
    return std::move(result_);
  }

 private:
  static constexpr std::size_t kLongestInlined = 64;  ///< characters

  using SignalId = std::size_t;
  static constexpr SignalId kNoSignal = ~SignalId{0};
  struct Signal {
    std::string name;
    std::uint32_t width = 1;
    bool is_signed = false;
    std::vector<bool> used;
    unsigned uses = 0, whole_uses = 0;  ///< expressions that read it, and of these the ones that are nothing else
    std::string inlined;                ///< text to write instead of the name
  };
  struct Reference {
    SignalId signal = kNoSignal;  ///< kNoSignal: constant, its value in index
    std::uint32_t index = 0;
    friend bool operator==(const Reference&, const Reference&) = default;
  };

  // Names -------------------------------------------------------------------------------------------------------------

  std::string unique(const std::string& wanted, std::string_view suffix = "") {
    std::string name = wanted + std::string(suffix);
    for (unsigned i = 2; !names_.insert(name).second; ++i)
      name = wanted + "_" + std::to_string(i) + std::string(suffix);
    return name;
  }

  SignalId signal(std::string name, std::uint32_t width, bool is_signed = false) {
    signals_.push_back({std::move(name), width, is_signed, std::vector<bool>(width, false), 0, 0, {}});
    return signals_.size() - 1;
  }

  void declare_ports() {
    for (const char* name : {"clk_i", "rst_ni", "en_i", "valid_i", "valid_o", "parity_error_o"}) names_.insert(name);
    result_.parity_error = parity();
    for (const Port& p : g_.inputs) input_.push_back(signal(unique(sanitise(p.name), "_i"), p.width, p.is_signed));
    for (const Port& p : g_.configs) {
      config_.push_back(signal(unique("cfg_" + sanitise(p.name), "_i"), p.width, p.is_signed));
    }
    for (const Port& p : g_.outputs) output_.push_back(unique(sanitise(p.name), "_o"));
    for (SignalId id : input_) result_.input_names.push_back(signals_[id].name);
    for (SignalId id : config_) result_.config_names.push_back(signals_[id].name);
    result_.output_names = output_;
    for (int stage = 0; stage < stages(); ++stage) names_.insert(enable(stage));
    for (int stage = 1; stage <= last_; ++stage) names_.insert(valid(stage));
  }

  int stages() const { return registered_ ? last_ : last_ + 1; }  ///< that hold logic
  static std::string enable(int stage) { return "s" + std::to_string(stage) + "_en"; }
  static std::string valid(int stage) { return stage == 0 ? "valid_i" : "valid_s" + std::to_string(stage) + "_q"; }

  void name_nodes() {
    node_signal_.assign(g_.nodes.size(), kNoSignal);
    base_name_.assign(g_.nodes.size(), "");
    for (const State& state : g_.states) {
      if (s_.stage[state.read] < 0) continue;
      base_name_[state.read] = sanitise(state.name);
      node_signal_[state.read] = signal(unique(base_name_[state.read], "_q"), state.width);
    }
    ram_name_.assign(g_.rams.size(), "");
    for (std::size_t r = 0; r < g_.rams.size(); ++r) {
      if (s_.ram_read_stage[r] < 0) continue;
      const Ram& ram = g_.rams[r];
      ram_name_[r] = unique(sanitise(ram.name), "_mem");
      ram_name_[r].resize(ram_name_[r].size() - 4);
      base_name_[ram.read] = ram_name_[r] + "_rdata";
      node_signal_[ram.read] = signal(unique(base_name_[ram.read], "_q"), ram.width);
    }
    for (NodeId n = 1; n < g_.nodes.size(); ++n) {
      const Node& node = g_.nodes[n];
      if (s_.stage[n] == kDead || node_signal_[n] != kNoSignal) continue;
      if (node.op == Op::kInput) {
        node_signal_[n] = input_.at(node.port);
        base_name_[n] = sanitise(g_.inputs[node.port].name);
      } else if (node.op == Op::kConfig) {
        node_signal_[n] = config_.at(node.port);
      } else {
        base_name_[n] =
            node.name.empty() ? std::string(mnemonic(node.op)) + "_" + std::to_string(n) : sanitise(node.name);
        const bool table = s_.synchronous_rom[n];
        node_signal_[n] = signal(unique(base_name_[n], table ? "_rdata_q" : ""), node.width);
        base_name_[n] = signals_[node_signal_[n]].name;
      }
    }
  }

  // Registers ---------------------------------------------------------------------------------------------------------

  /// Bits that a state register holds one stage later anyway.
  void find_shared_registers() {
    for (const State& state : g_.states) {
      const int stage = s_.stage[state.read];
      if (stage < 0) continue;
      for (std::uint32_t i = 0; i < state.width; ++i) {
        const Bit b = state.next[i];
        if (b.node == 0 || b == Bit{state.read, i} || s_.stage[b.node] == kEveryStage) continue;
        shared_.try_emplace({b, stage + 1}, Reference{node_signal_[state.read], i});
      }
    }
  }

  void demand(Bit b, int stage) {
    const int made = s_.stage[b.node];
    if (b.node == 0 || made == kEveryStage) return;
    for (int j = stage; j > made && !shared_.contains({b, j}); --j) {
      if (!registers_[{j, b.node}].insert(b.index).second) return;
    }
  }
  void demand(const Bits& bits, int stage) {
    for (Bit b : bits) demand(b, stage);
  }

  void find_registers() {
    for (NodeId n = 1; n < g_.nodes.size(); ++n) {
      const int stage = s_.stage[n];
      if (stage < 0) continue;
      for (const Bits& operand : g_.nodes[n].operands) demand(operand, s_.synchronous_rom[n] ? stage - 1 : stage);
    }
    for (const State& state : g_.states) {
      if (s_.stage[state.read] >= 0) demand(state.next, s_.stage[state.read]);
    }
    for (std::size_t r = 0; r < g_.rams.size(); ++r) {
      const int read = s_.ram_read_stage[r], write = s_.ram_write_stage[r];
      if (read < 0) continue;
      demand(g_.rams[r].read_address, read);
      demand(g_.rams[r].read_enable, read);
      if (write < 0) continue;
      demand(g_.rams[r].write_address, write);
      demand(g_.rams[r].write_data, write);
      demand(g_.rams[r].write_enable, write);
    }
    for (const Port& out : g_.outputs) {
      for (Bit b : out.value) {
        if (registered_ && b.node != 0 && s_.stage[b.node] == kEveryStage) {
          output_static_.try_emplace(b, output_static_.size());
        } else {
          demand(b, last_);
        }
      }
    }
    demand(g_.output_valid, stages() - 1);
    for (const auto& [key, bits] : registers_) {
      const auto& [stage, node] = key;
      const std::string name = unique(base_name_[node] + "_s" + std::to_string(stage), "_q");
      register_signal_[key] = signal(name, static_cast<std::uint32_t>(bits.size()));
      result_.pipeline_bits += bits.size();
    }
    if (!output_static_.empty()) {
      static_register_ = signal(unique("config", "_q"), static_cast<std::uint32_t>(output_static_.size()));
      result_.pipeline_bits += output_static_.size();
    }
    result_.pipeline_bits += static_cast<unsigned long>(last_);  // valid bits
  }

  Reference resolve(Bit b, int stage) const {
    if (b.node == 0) return {kNoSignal, b.index};
    const int made = s_.stage[b.node];
    if (registered_ && made == kEveryStage && stage == last_)
      return {static_register_, static_cast<std::uint32_t>(output_static_.at(b))};
    if (made == kEveryStage || made == stage) return {node_signal_[b.node], b.index};
    if (const auto it = shared_.find({b, stage}); it != shared_.end()) return it->second;
    const auto& bits = registers_.at({stage, b.node});
    return {register_signal_.at({stage, b.node}),
            static_cast<std::uint32_t>(std::distance(bits.begin(), bits.find(b.index)))};
  }

  // Expressions -------------------------------------------------------------------------------------------------------

  std::string slice(SignalId id, std::uint32_t high, std::uint32_t low) {
    Signal& s = signals_[id];
    for (auto i = low; i <= high; ++i) s.used[i] = true;
    ++s.uses;
    if (!s.inlined.empty()) return "(" + s.inlined + ")";
    // A port declared signed would make comparisons signed and addresses negative.
    if (high - low + 1 == s.width) return s.is_signed ? "$unsigned(" + s.name + ")" : s.name;
    if (high == low) return s.name + "[" + std::to_string(low) + "]";
    return s.name + "[" + std::to_string(high) + ":" + std::to_string(low) + "]";
  }

  /// An operand: a name, a slice, a literal or a concatenation, never in need of parentheses.
  std::string expression(const Bits& bits, int stage) {
    std::vector<Reference> r;
    r.reserve(bits.size());
    for (Bit b : bits) r.push_back(resolve(b, stage));
    return expression(r);
  }

  std::string expression(const std::vector<Reference>& r) {
    std::vector<std::string> pieces;
    for (std::size_t high = r.size(); high > 0;) {
      const Reference top = r[high - 1];
      std::size_t low = high - 1;
      if (top.signal == kNoSignal) {
        while (low > 0 && r[low - 1].signal == kNoSignal) --low;
        std::vector<bool> value;
        for (std::size_t i = low; i < high; ++i) value.push_back(r[i].index != 0);
        pieces.push_back(literal(value));
      } else if (low > 0 && r[low - 1] == top) {
        while (low > 0 && r[low - 1] == top) --low;
        // The sign bit itself belongs to the slice below it.
        const bool belongs = low > 0 && r[low - 1].signal == top.signal && r[low - 1].index + 1 == top.index;
        if (belongs) ++low;
        const std::string bit = slice(top.signal, top.index, top.index);
        pieces.push_back(high - low == 1 ? bit : "{" + std::to_string(high - low) + "{" + bit + "}}");
      } else {
        while (low > 0 && r[low - 1].signal == top.signal && r[low - 1].index + 1 == r[low].index) --low;
        pieces.push_back(slice(top.signal, top.index, r[low].index));
      }
      high = low;
    }
    if (pieces.size() == 1) {
      const SignalId id = r.front().signal;
      if (id != kNoSignal && r.front().index == 0 && r.size() == signals_[id].width) ++signals_[id].whole_uses;
      return pieces.front();
    }
    std::string text = "{";
    for (std::size_t i = 0; i < pieces.size(); ++i) text += (i == 0 ? "" : ", ") + pieces[i];
    return text + "}";
  }

  /// The right side of an assignment: no outer parentheses.
  std::string assigned(const Bits& bits, int stage) {
    const std::string text = expression(bits, stage);
    return text.starts_with('(') ? text.substr(1, text.size() - 2) : text;
  }

  /// Operations whose value does not change inside an expression of equal width: a signed shift or product would
  /// become unsigned.
  static bool inlinable(Op op) {
    switch (op) {
      case Op::kAnd:
      case Op::kOr:
      case Op::kXor:
      case Op::kNot:
      case Op::kAdd:
      case Op::kSub:
      case Op::kEq:
      case Op::kUlt:
      case Op::kSlt:
      case Op::kMux:
      case Op::kReduceOr:
      case Op::kReduceAnd:
      case Op::kReduceXor:
        return true;
      default:
        return false;
    }
  }

  /// `bits` extended to `width`; the extension bit is the last one or zero.
  static Bits extended(Bits bits, std::uint32_t width, bool with_sign) {
    const Bit extension = with_sign && !bits.empty() ? bits.back() : kZero;
    bits.resize(width, extension);
    return bits;
  }

  std::string operation(NodeId n, int stage) {
    const Node& node = g_.nodes[n];
    const auto operand = [&](std::size_t i) { return expression(node.operands[i], stage); };
    const auto binary = [&](const char* symbol) { return operand(0) + " " + symbol + " " + operand(1); };
    const auto shift = [&](const char* symbol) {
      if (node.operands[1].size() > 31) throw ScheduleError(node.where, "a shift amount of more than 31 bits");
      return operand(0) + " " + symbol + " " + operand(1);
    };
    switch (node.op) {
      case Op::kAnd:
        return binary("&");
      case Op::kOr:
        return binary("|");
      case Op::kXor:
        return binary("^");
      case Op::kNot:
        return "~" + operand(0);
      case Op::kAdd:
        return binary("+");
      case Op::kSub:
        return binary("-");
      case Op::kMul:
        return expression(extended(node.operands[0], node.width, false), stage) + " * " +
               expression(extended(node.operands[1], node.width, false), stage);
      case Op::kMulSigned:
        return "$signed(" + expression(extended(node.operands[0], node.width, true), stage) + ") * $signed(" +
               expression(extended(node.operands[1], node.width, true), stage) + ")";
      case Op::kShl:
        return shift("<<");
      case Op::kLshr:
        return shift(">>");
      case Op::kAshr:
        if (node.operands[1].size() > 31) throw ScheduleError(node.where, "a shift amount of more than 31 bits");
        return "$signed(" + operand(0) + ") >>> " + operand(1);
      case Op::kEq:
        return binary("==");
      case Op::kUlt:
        return binary("<");
      case Op::kSlt:
        return "$signed(" + operand(0) + ") < $signed(" + operand(1) + ")";
      case Op::kMux:
        return operand(0) + " ? " + operand(1) + " : " + operand(2);
      case Op::kReduceOr:
        return "|" + operand(0);
      case Op::kReduceAnd:
        return "&" + operand(0);
      case Op::kReduceXor:
        return "^" + operand(0);
      default:
        throw ScheduleError(node.where, "internal: operation cannot be emitted");
    }
  }

  // Text --------------------------------------------------------------------------------------------------------------

  std::string place(const SourceLocation& where) const {
    std::string file = where.file;
    if (!o_.source_root.empty() && file.starts_with(o_.source_root)) file.erase(0, o_.source_root.size());
    while (file.starts_with('/') && !o_.source_root.empty()) file.erase(0, 1);
    return file + ":" + std::to_string(where.line);
  }

  void emit_header(std::ostream& out) const {
    unsigned long memory_bits = 0;
    for (const auto& m : result_.memories) memory_bits += static_cast<unsigned long>(m.depth) * m.width;
    out << "// SPDX-License-Identifier: Apache-2.0\n// Made by hlsc";
    if (!o_.source_class.empty()) out << " from " << o_.source_class;
    if (!g_.source_file.empty()) out << (o_.source_class.empty() ? " from " : ", ") << place_file(g_.source_file);
    out << ". Do not edit.\n//\n"
        << "// Latency " << last_
        << " enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs\n"
        << "// change only with a valid beat. rst_ni is synchronous and keeps memories.\n"
        << (registered_ ? "" : "// Outputs are logic: what they go to takes them with the clock if en_i = 1.\n")
        << "// State " << result_.state_bits << " bits, pipeline " << result_.pipeline_bits << " bits, memories "
        << memory_bits << " bits.\n"
        << "module " << g_.top_name << " (\n  input  logic clk_i,\n  input  logic rst_ni,\n  input  logic en_i,\n"
        << "  input  logic valid_i,\n";
    const auto port = [&](const char* direction, const Port& p, const std::string& name, bool last) {
      out << "  " << direction << " logic " << (p.is_signed ? "signed " : "") << range(p.width) << name
          << (last ? "\n" : ",\n");
    };
    for (std::size_t i = 0; i < g_.inputs.size(); ++i) port("input ", g_.inputs[i], signals_[input_[i]].name, false);
    for (std::size_t i = 0; i < g_.configs.size(); ++i) port("input ", g_.configs[i], signals_[config_[i]].name, false);
    if (parity()) out << "  output logic parity_error_o,\n";
    out << "  output logic valid_o" << (g_.outputs.empty() ? "\n" : ",\n");
    for (std::size_t i = 0; i < g_.outputs.size(); ++i) {
      port("output", g_.outputs[i], output_[i], i + 1 == g_.outputs.size());
    }
    out << ");\n";
  }

  std::string place_file(const std::string& file) const {
    std::string text = place({file, 0});
    return text.substr(0, text.rfind(':'));
  }

  void emit_valid(std::ostream& out) {
    out << "\n  // A beat is in stage k, k enabled clocks after it entered.\n";
    for (int k = 1; k <= last_; ++k) out << (k == 1 ? "  logic " : ", ") << valid(k) << (k == last_ ? ";\n" : "");
    std::vector<int> needed;
    for (int k = 0; k < stages(); ++k) {
      if (uses_enable(k) || loads_outputs(k)) needed.push_back(k);
    }
    if (needed.empty()) return;
    for (int k : needed) out << (k == needed.front() ? "  logic " : ", ") << enable(k);
    out << ";\n";
    for (int k : needed) out << "  assign " << enable(k) << " = en_i & " << valid(k) << ";\n";
  }

  /// Registers of the pipeline load in every enabled clock, whether a beat is in the stage or not: `valid` would go to all
  /// of them, and its way there is what takes the time. Outputs keep what the last beat gave.
  bool loads_outputs(int stage) const { return registered_ && stage + 1 == last_; }

  /// Does anything load in this stage, but for registers of the pipeline?
  bool uses_enable(int stage) const {
    const bool state = std::ranges::any_of(g_.states, [&](const State& s) { return s_.stage[s.read] == stage; });
    return state || std::ranges::find(s_.ram_read_stage, stage) != s_.ram_read_stage.end() ||
           std::ranges::find(s_.ram_write_stage, stage) != s_.ram_write_stage.end();
  }

  void emit_static(std::ostream& out) {
    bool any = false;
    for (NodeId n = 1; n < g_.nodes.size(); ++n) {
      if (s_.stage[n] != kEveryStage || g_.nodes[n].op == Op::kConfig) continue;
      if (!any) out << "\n  // Of the configuration alone: not pipelined.\n";
      any = true;
      emit_node(out, n, 0);
    }
  }

  void emit_node(std::ostream& out, NodeId n, int stage) {
    const Node& node = g_.nodes[n];
    Signal& s = signals_[node_signal_[n]];
    if (!may_inline_.empty() && may_inline_[n]) {
      const std::string text = operation(n, stage);
      if (text.size() <= kLongestInlined) {
        s.inlined = text;
        return;
      }
      out << "  logic " << range(s.width) << s.name << ";\n  assign " << s.name << " = " << text << ";\n";
      return;
    }
    out << "  logic " << range(s.width) << s.name << ";";
    if (node.op == Op::kRom) {
      const Rom& rom = g_.roms[node.port];
      const auto width = static_cast<std::uint32_t>(node.operands[0].size());
      out << "  // table " << sanitise(rom.name) << "\n  always_comb begin\n    case ("
          << expression(node.operands[0], stage) << ")\n";
      for (std::size_t i = 0; i < rom.words.size() && (width >= 32 || i < (std::size_t{1} << width)); ++i) {
        if (std::ranges::find(rom.words[i], true) == rom.words[i].end()) continue;
        out << "      " << width << "'d" << i << ": " << s.name << " = " << literal(word(rom, i, node.width)) << ";\n";
      }
      out << "      default: " << s.name << " = " << literal(std::vector<bool>(node.width, false))
          << ";\n    endcase\n  end\n";
      return;
    }
    out << "\n  assign " << s.name << " = " << operation(n, stage) << ";\n";
  }

  static std::vector<bool> word(const Rom& rom, std::size_t i, std::uint32_t width) {
    std::vector<bool> bits = i < rom.words.size() ? rom.words[i] : std::vector<bool>{};
    bits.resize(width, false);
    return bits;
  }

  void emit_stage(std::ostream& out, int stage) {
    const auto headline = [&](const std::string& title) {
      out << "\n  // " << title << " " << std::string(114 - title.size(), '-') << "\n";
    };
    if (stage < stages()) emit_logic(out, stage, headline);
    if (stage < last_) return;
    if (parity()) {
      headline("Parity");
      out << "  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (";
      const char* before = "";
      for (std::size_t r = 0; r < ram_name_.size(); ++r) {
        if (s_.ram_read_stage[r] < 0) continue;
        out << before << ram_name_[r] << "_error";
        before = " | ";
      }
      out << ");\n";
    }
    headline("Outputs");
    for (std::size_t i = 0; i < g_.outputs.size(); ++i) {
      out << "  assign " << output_[i] << " = " << assigned(g_.outputs[i].value, last_) << ";\n";
    }
    out << "  assign valid_o = " << valid(last_);
    if (!registered_ && g_.output_valid != kOne) out << " & " << expression(Bits{g_.output_valid}, last_);
    out << ";\n";
  }

  template <class Headline>
  void emit_logic(std::ostream& out, int stage, Headline headline) {
    headline("Stage " + std::to_string(stage));
    for (const State& state : g_.states) {
      if (s_.stage[state.read] != stage) continue;
      const Signal& s = signals_[node_signal_[state.read]];
      out << "  logic " << range(s.width) << s.name << ";\n";
      result_.state_bits += s.width;
    }
    SourceLocation where;
    for (NodeId n = 1; n < g_.nodes.size(); ++n) {
      const Op op = g_.nodes[n].op;
      if (s_.stage[n] != stage || op == Op::kInput || op == Op::kStateRead || op == Op::kRamRead ||
          s_.synchronous_rom[n]) {
        continue;
      }
      std::ostringstream text;
      emit_node(text, n, stage);
      if (text.str().empty()) continue;
      const SourceLocation& here = g_.nodes[n].where;
      if (!here.file.empty() && (here.file != where.file || here.line != where.line)) {
        out << "  // " << place(here) << "\n";
        where = here;
      }
      out << text.str();
    }
    for (std::size_t r = 0; r < g_.rams.size(); ++r) {
      if (s_.ram_read_stage[r] == stage) emit_memory_read(out, r);
    }
    for (NodeId n = 1; n < g_.nodes.size(); ++n) {
      if (s_.synchronous_rom[n] && s_.stage[n] == stage + 1) emit_table(out, n);
    }
    for (std::size_t r = 0; r < g_.rams.size(); ++r) {
      if (s_.ram_write_stage[r] == stage) emit_memory_write(out, r);
    }
    emit_registers(out, stage);
  }

  void emit_registers(std::ostream& out, int stage) {
    std::ostringstream declare, load, reset, load_state, load_kept, power_up;
    for (const auto& [key, id] : register_signal_) {
      if (key.first != stage + 1) continue;
      Bits bits;
      for (std::uint32_t i : registers_.at(key)) bits.push_back({key.second, i});
      declare << "  logic " << range(signals_[id].width) << signals_[id].name << ";\n";
      load << "      " << signals_[id].name << " <= " << assigned(bits, stage) << ";\n";
    }
    if (stage + 1 == last_ && static_register_ != kNoSignal) {
      Bits bits(output_static_.size());
      for (const auto& [bit, index] : output_static_) bits[index] = bit;
      declare << "  logic " << range(signals_[static_register_].width) << signals_[static_register_].name << ";\n";
      load << "      " << signals_[static_register_].name << " <= " << assigned(bits, stage) << ";\n";
    }
    for (const State& state : g_.states) {
      if (s_.stage[state.read] != stage) continue;
      const std::string& name = signals_[node_signal_[state.read]].name;
      std::vector<bool> initial = state.initial;
      initial.resize(state.width, false);
      if (state.kept) {
        power_up << "    " << name << " = " << literal(initial) << ";\n";
      } else {
        reset << "      " << name << " <= " << literal(initial) << ";\n";
      }
      (state.kept ? load_kept : load_state) << "      " << name << " <= " << assigned(state.next, stage) << ";\n";
    }
    if (!reset.str().empty()) {
      out << "\n  always_ff @(posedge clk_i) begin\n    if (!rst_ni) begin\n"
          << reset.str() << "    end else if (" << enable(stage) << ") begin\n"
          << load_state.str() << "    end\n  end\n";
    }
    if (!load_kept.str().empty()) {
      out << "\n  // Not reset: nothing of it counts before it is written anew.\n`ifndef SYNTHESIS\n  initial begin\n"
          << power_up.str()
          << "  end\n`endif\n  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too\n    if ("
          << (stage == 0 ? "rst_ni & " : "") << enable(stage) << ") begin\n"
          << load_kept.str() << "    end\n  end\n";
    }
    if (!load.str().empty()) {
      out << "\n"
          << declare.str() << "  always_ff @(posedge clk_i) begin\n    if ("
          << (loads_outputs(stage) ? enable(stage) : "en_i") << ") begin\n"
          << load.str() << "    end\n  end\n";
    }
  }

  // The valid bits; at the end, because the last one may depend on the leaf `valid` of Out.
  void emit_valid_registers(std::ostream& out) {
    if (last_ == 0) return;
    out << "\n  always_ff @(posedge clk_i) begin\n    if (!rst_ni) begin\n";
    for (int k = 1; k <= last_; ++k) out << "      " << valid(k) << " <= 1'b0;\n";
    out << "    end else if (en_i) begin\n";
    for (int k = 1; k <= last_; ++k) {
      out << "      " << valid(k) << " <= " << valid(k - 1);
      if (registered_ && k == last_ && g_.output_valid != kOne)
        out << " & " << expression(Bits{g_.output_valid}, last_ - 1);
      out << ";\n";
    }
    out << "    end\n  end\n";
  }

  // Memories ----------------------------------------------------------------------------------------------------------

  std::string address_index(const std::string& wire, std::size_t width, std::uint32_t needed) const {
    if (width == needed) return wire;
    if (width > needed) return wire + (needed == 1 ? "[0]" : "[" + std::to_string(needed - 1) + ":0]");
    return "{" + std::to_string(needed - width) + "'d0, " + wire + "}";
  }

  /// A simulation check that an address of `width` bits lies within `depth` words.
  static std::string outside(const std::string& wire, std::size_t width, std::uint64_t depth) {
    if (width < 64 && (std::uint64_t{1} << width) <= depth) return "";
    return wire + " >= " + std::to_string(width) + "'d" + std::to_string(depth);
  }

  [[nodiscard]] bool parity() const {
    return o_.ram_parity && std::ranges::any_of(s_.ram_read_stage, [](int stage) { return stage >= 0; });
  }

  void emit_memory_read(std::ostream& out, std::size_t r) {
    const Ram& ram = g_.rams[r];
    const std::string& name = ram_name_[r];
    const int stage = s_.ram_read_stage[r], write = s_.ram_write_stage[r];
    const auto width = ram.read_address.size();
    const std::uint32_t stored = ram.width + (parity() ? 1 : 0);
    result_.memories.push_back({name, ram.depth, stored, ram.distance, stage, write});
    out << "\n  // Memory " << name << ", " << ram.depth << " x " << ram.width << (parity() ? " and parity" : "")
        << ", DISTANCE " << ram.distance << ", " << place(ram.where) << "; read in stage " << stage;
    if (write >= 0)
      out << ", written in stage " << write << ": " << stage << " < " << write << " < " << stage << " + DISTANCE";
    out << ".\n";
    if (write >= 0) {
      out << "  // So no address is read and written in one clock, and synthesis needs no bypass.\n  (* no_rw_check "
             "*)\n";
    }
    if (is_distributed(ram)) out << "  (* ram_style = \"distributed\" *)\n";
    out << "  logic " << range(stored) << name << "_mem [0:" << ram.depth - 1 << "];\n"
        << "`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop\n"
        << "  initial for (int i = 0; i < " << ram.depth << "; i++) " << name
        << "_mem[i] = " << literal(std::vector<bool>(stored, false)) << ";\n`endif\n"
        << "  logic " << range(static_cast<std::uint32_t>(width)) << name << "_raddr;\n  assign " << name
        << "_raddr = " << assigned(ram.read_address, stage) << ";\n";
    // What is read without being asked for means nothing: an enable would only have a way to every block memory.
    const std::string asked = "  logic " + name + "_re;\n  assign " + name + "_re = " + enable(stage) +
                              (ram.read_enable != kOne ? " & " + expression(Bits{ram.read_enable}, stage) : "") + ";\n";
    out << (parity() ? asked : "`ifndef SYNTHESIS\n" + asked + "`endif\n");
    const std::string& data = signals_[node_signal_[ram.read]].name;
    const std::string word = parity() ? name + "_word_q" : data;
    out << "  logic " << range(stored) << word << ";\n"
        << "  always_ff @(posedge clk_i) begin\n    if (" << (loads_outputs(stage) ? enable(stage) : "en_i") << ") "
        << word << " <= " << name << "_mem[" << address_index(name + "_raddr", width, address_bits(ram.depth))
        << "];\n  end\n";
    if (!parity()) return;
    out << "  logic " << range(ram.width) << data << ";\n  assign " << data << " = " << word << "[" << ram.width - 1
        << ":0];\n  logic " << name << "_read_q, " << name << "_error;\n"
        << "  always_ff @(posedge clk_i) " << name << "_read_q <= rst_ni & " << name << "_re;\n  assign " << name
        << "_error = " << name << "_read_q & ^" << word << ";\n";
  }

  void emit_memory_write(std::ostream& out, std::size_t r) {
    const Ram& ram = g_.rams[r];
    const std::string& name = ram_name_[r];
    const int read = s_.ram_read_stage[r], stage = s_.ram_write_stage[r];
    const auto width = ram.write_address.size();
    out << "\n  // Memory " << name << ", write\n  logic " << range(static_cast<std::uint32_t>(width)) << name
        << "_waddr;\n  assign " << name << "_waddr = " << assigned(ram.write_address, stage) << ";\n  logic " << name
        << "_we;\n  assign " << name << "_we = " << enable(stage);
    if (ram.write_enable != kOne) out << " & " << expression(Bits{ram.write_enable}, stage);
    std::string word = assigned(ram.write_data, stage);
    if (parity()) {
      out << ";\n  logic " << range(ram.width) << name << "_wdata;\n  assign " << name << "_wdata = " << word;
      word = "{^" + name + "_wdata, " + name + "_wdata}";
    }
    out << ";\n  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too\n    if (" << name << "_we) "
        << name << "_mem[" << address_index(name + "_waddr", width, address_bits(ram.depth)) << "] <= " << word
        << ";\n  end\n";
    // Later beats whose reads have already happened, or happen in this clock, must not have read this address.
    out << "`ifndef SYNTHESIS\n";
    const auto reader_width = ram.read_address.size();
    const auto compared = std::max(reader_width, width);
    const auto wide = [&](const std::string& wire, std::size_t bits) {
      return bits == compared ? wire : "{" + std::to_string(compared - bits) + "'d0, " + wire + "}";
    };
    const auto at = [&](int k, const char* what) {
      return k == read ? name + "_" + what : name + "_" + what + "_s" + std::to_string(k) + "_sim";
    };
    for (int k = read + 1; k < stage; ++k) {
      out << "  logic " << range(static_cast<std::uint32_t>(reader_width)) << at(k, "raddr") << ";\n  logic "
          << at(k, "re") << ";\n";
    }
    if (read + 1 < stage) {
      out << "  always_ff @(posedge clk_i) begin\n    if (!rst_ni) begin\n";
      for (int k = read + 1; k < stage; ++k) out << "      " << at(k, "re") << " <= 1'b0;\n";
      out << "    end else if (en_i) begin\n";
      for (int k = read + 1; k < stage; ++k) {
        out << "      " << at(k, "re") << " <= " << at(k - 1, "re") << ";\n      " << at(k, "raddr")
            << " <= " << at(k - 1, "raddr") << ";\n";
      }
      out << "    end\n  end\n";
    }
    out << "  always_ff @(posedge clk_i) begin\n    if (rst_ni && " << name << "_we) begin\n";
    for (int k = read; k < stage; ++k) {
      out << "      if (" << at(k, "re") << " && " << wide(at(k, "raddr"), reader_width)
          << " == " << wide(name + "_waddr", width) << ") begin\n        $error(\"" << name
          << ": address %0d is read less than DISTANCE steps after its write\", " << name << "_waddr);\n      end\n";
    }
    if (const auto check = outside(name + "_waddr", width, ram.depth); !check.empty()) {
      out << "      if (" << check << ") $error(\"" << name << ": write outside, address %0d\", " << name
          << "_waddr);\n";
    }
    out << "    end\n";
    if (const auto check = outside(name + "_raddr", reader_width, ram.depth); !check.empty()) {
      out << "    if (rst_ni && " << name << "_re && " << check << ") $error(\"" << name
          << ": read outside, address %0d\", " << name << "_raddr);\n";
    }
    out << "  end\n`endif\n";
  }

  void emit_table(std::ostream& out, NodeId n) {
    const Node& node = g_.nodes[n];
    const Rom& rom = g_.roms[node.port];
    const auto width = static_cast<std::uint32_t>(node.operands[0].size());
    if (width > 16) throw ScheduleError(node.where, "a table of more than 65536 words");
    const std::size_t depth = std::size_t{1} << width;
    const std::string& data = signals_[node_signal_[n]].name;
    const std::string memory = unique(sanitise(rom.name), "_rom");
    result_.memories.push_back({memory, static_cast<std::uint32_t>(depth), node.width, 0, s_.stage[n] - 1, -1});
    out << "\n  // Table " << sanitise(rom.name) << ", " << depth << " x " << node.width << ", " << place(node.where)
        << "\n  logic " << range(node.width) << memory << " [0:" << depth - 1 << "];\n  initial begin\n";
    for (std::size_t i = 0; i < depth; ++i) {
      out << "    " << memory << "[" << i << "] = " << literal(word(rom, i, node.width)) << ";\n";
    }
    out << "  end\n  logic " << range(node.width) << data << ";\n  always_ff @(posedge clk_i) begin\n    if (en_i) "
        << data << " <= " << memory << "[" << expression(node.operands[0], s_.stage[n] - 1) << "];\n  end\n";
  }

  /// Low bits of sums and the like: named as unused, so that lint stays strict elsewhere.
  void emit_unused(std::ostream& out) {
    std::vector<Reference> unused;
    for (SignalId id = 0; id < signals_.size(); ++id) {
      for (std::uint32_t i = 0; i < signals_[id].width; ++i) {
        if (!signals_[id].used[i]) unused.push_back({id, i});
      }
    }
    const bool clocked = last_ > 0 || uses_enable(0);
    if (unused.empty() && clocked) return;
    out << "\n  // Nothing depends on these bits.\n  logic unused_bits;\n  assign unused_bits = ^";
    if (clocked) {
      out << expression(unused);
    } else {
      out << "{clk_i, rst_ni, en_i" << (unused.empty() ? "" : ", " + expression(unused)) << "}";
    }
    out << ";\n";
  }

  const Graph& g_;
  const Schedule& s_;
  const EmitOptions& o_;
  int last_;
  bool registered_;
  std::vector<bool> may_inline_;
  EmittedModule result_;
  std::set<std::string> names_;
  std::vector<Signal> signals_;
  std::vector<SignalId> input_, config_, node_signal_;
  std::vector<std::string> output_, base_name_, ram_name_;
  std::map<std::pair<Bit, int>, Reference> shared_;
  std::map<std::pair<int, NodeId>, std::set<std::uint32_t>> registers_;
  std::map<std::pair<int, NodeId>, SignalId> register_signal_;
  std::map<Bit, std::size_t> output_static_;
  SignalId static_register_ = kNoSignal;
};

}  // namespace

EmittedModule emit(const Graph& graph, const Schedule& schedule, const EmitOptions& options) {
  Emitter trial(graph, schedule, options, {});
  trial.run();
  return Emitter(graph, schedule, options, trial.used_once()).run();
}

}  // namespace hlsc
