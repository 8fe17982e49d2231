// SPDX-License-Identifier: Apache-2.0
// Writes random stage classes for hlsc, always within the language of hls/README.md, without undefined behaviour and
// with every DISTANCE kept. The same seed gives the same class.
//
//   random_program_generator SEED > program.hpp       class horopter::random_programs::P<SEED>
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "horopter/tb/random.hpp"

namespace {

using horopter::tb::Rng;
using std::to_string;

struct Type {
  enum class Kind { boolean, u, s, builtin_unsigned, builtin_signed };
  Kind kind = Kind::boolean;
  int width = 1;
  bool fixed() const { return kind == Kind::u || kind == Kind::s; }
  bool is_signed() const { return kind == Kind::s || kind == Kind::builtin_signed; }
  /// Bits that the value needs as a signed number.
  int signed_width() const { return width + (is_signed() ? 0 : 1); }
  std::string name() const {
    switch (kind) {
      case Kind::boolean:
        return "bool";
      case Kind::u:
        return "u<" + to_string(width) + ">";
      case Kind::s:
        return "s<" + to_string(width) + ">";
      case Kind::builtin_unsigned:
        return "std::uint" + to_string(width) + "_t";
      case Kind::builtin_signed:
        return "std::int" + to_string(width) + "_t";
    }
    return {};
  }
  friend bool operator==(const Type&, const Type&) = default;
};
using Kind = Type::Kind;
const Type kBool{};
Type u(int width) { return {Kind::u, width}; }
Type s(int width) { return {Kind::s, width}; }

struct Expression {
  std::string text;
  Type type;
};

struct Field {
  std::string name;
  Type type;
  int elements = 0;  ///< 0: no array
};

struct Struct {
  std::string name;
  std::vector<Field> fields;
};

struct Variable {
  std::string name;
  Type type;
  bool writable = false;
};

struct Array {
  std::string name;
  Type type;
  int elements = 0;
  bool writable = false;
};

struct StructVariable {
  std::string name;
  int type = 0;  ///< index into structs_
};

struct Function {
  std::string name;
  Type result;
  std::vector<Type> parameters;
};

int log2_ceil(int n) {
  int bits = 1;
  while ((1 << bits) < n) ++bits;
  return bits;
}

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : seed_{seed}, rng_{seed} { rng_.next(); }

  std::string program() {
    const std::string name = "P" + to_string(seed_);
    plan();
    const std::string step = step_body();
    std::string text =
        "// Random program " + to_string(seed_) +
        ".\n#pragma once\n\n#include <algorithm>\n#include <array>\n"
        "#include <bit>\n#include <cstdint>\n\n#include \"horopter/hls/int.hpp\"\n#include \"horopter/hls/ram.hpp\"\n\n"
        "namespace horopter::random_programs {\nusing namespace horopter::hls;  // NOLINT\n\nclass " +
        name + " {\n public:\n";
    for (const Struct& type : structs_) text += struct_text(type);
    text += struct_text({"In", in_}) + struct_text({"Out", out_});
    if (!config_.empty()) text += struct_text({"Config", config_});
    text += "\n  Out step(const In& in" + std::string{config_.empty() ? "" : ", const Config& config"} + ") {\n" +
            step + "  }\n\n private:\n";
    text += members_;
    text += "};\n\n}  // namespace horopter::random_programs\n";
    return text;
  }

 private:
  // ---- choices ----
  int pick(int n) { return static_cast<int>(rng_.below(static_cast<std::uint64_t>(n))); }
  bool chance(unsigned percent) { return rng_.percent(percent); }
  template <class T>
  const T& one_of(const std::vector<T>& values) {
    return values[rng_.below(values.size())];
  }
  int random_width() {
    if (chance(4)) return 33 + pick(32);
    if (chance(15)) return 1 + pick(32);
    return 1 + pick(14);
  }
  Type fixed_type() { return chance(60) ? u(random_width()) : s(std::max(2, random_width())); }
  Type leaf_type() { return chance(15) ? kBool : fixed_type(); }
  Type value_type() {
    if (chance(8)) {
      static constexpr int kWidths[] = {8, 16, 32, 64};
      return {chance(60) ? Kind::builtin_unsigned : Kind::builtin_signed, kWidths[pick(chance(80) ? 3 : 4)]};
    }
    return leaf_type();
  }

  // ---- the class ----
  void plan() {
    const int structs = pick(3);
    for (int n = 0; n < structs; ++n) {
      Struct type{"T" + to_string(n), {}};
      const int fields = 1 + pick(4);
      for (int k = 0; k < fields; ++k)
        type.fields.push_back({"m" + to_string(k), leaf_type(), chance(20) ? 2 + pick(2) : 0});
      structs_.push_back(type);
    }
    ports(in_, "i", 1 + pick(5));
    ports(out_, "o", 1 + pick(4));
    if (chance(30)) out_.insert(out_.begin() + pick(static_cast<int>(out_.size()) + 1), {"valid", kBool, 0});
    if (chance(40)) ports(config_, "c", 1 + pick(2));
    add_inputs("in", in_);
    add_inputs("config", config_);

    // Registers that depend on inputs only, so that addresses and enables of memories may use them: a recurrence cannot
    // pass through a memory, which takes a clock to read.
    const int controls = pick(3);
    for (int n = 0; n < controls; ++n) {
      const Variable v{"k" + to_string(n) + "_", chance(30) ? kBool : u(1 + pick(8)), false};
      members_ += "  " + v.type.name() + " " + v.name + "{" + literal(v.type) + "};\n";
      controls_.push_back(v);
    }
    for (const Variable& v : controls_) control_updates_ += "    " + v.name + " = " + deferred_of(v.type) + ";\n";
    state_ = controls_;

    const int registers = 1 + pick(5);
    for (int n = 0; n < registers; ++n) {
      const Variable v{"r" + to_string(n) + "_", value_type(), true};
      members_ += "  " + v.type.name() + " " + v.name + "{" + literal(v.type) + "};\n";
      state_.push_back(v);
    }
    if (chance(50)) {
      const Array a{"a_", leaf_type(), 1 << (1 + pick(3)), true};
      members_ += "  " + array_type(a) + " " + a.name + initialiser(a) + ";\n";
      arrays_.push_back(a);
    }
    if (chance(30)) {
      const Array a{"delay_", leaf_type(), 2 + pick(6), true};
      members_ += "  " + array_type(a) + " " + a.name + "{};\n";
      shift_register_ = a;
    }
    if (!structs_.empty() && chance(60)) {
      struct_state_.push_back({"t_", pick(static_cast<int>(structs_.size()))});
      members_ += "  " + structs_[static_cast<std::size_t>(struct_state_.back().type)].name + " t_{};\n";
    }
    const int roms = chance(40) ? 1 + pick(2) : 0;
    for (int n = 0; n < roms; ++n) {
      const Array rom{"kTable" + to_string(n), chance(90) ? fixed_type() : kBool, 1 << (1 + pick(6)), false};
      members_ += "  static constexpr " + array_type(rom) + " " + rom.name + initialiser(rom) + ";\n";
      roms_.push_back(rom);
    }
    if (chance(25)) {
      mode_ = true;
      members_ += "  enum class Mode : std::uint8_t { idle, run, hold };\n  Mode mode_ = Mode::" +
                  std::string{chance(50) ? "idle" : "hold"} + ";\n";
    }
    const int functions = pick(3);
    for (int n = 0; n < functions; ++n) function(n);
    const int rams = chance(75) ? 1 + pick(3) : 0;
    for (int n = 0; n < rams; ++n) ram(n);
  }

  void ports(std::vector<Field>& fields, const std::string& prefix, int count) {
    for (int n = 0; n < count; ++n)
      fields.push_back({prefix + to_string(n), leaf_type(), chance(15) ? 1 + pick(4) : 0});
    if (prefix != "c" && !structs_.empty() && chance(30)) nested_.push_back(prefix);
  }

  std::string struct_text(const Struct& type) {
    std::string text = "  struct " + type.name + " {\n";
    for (const Field& field : type.fields) {
      text += "    " + (field.elements ? array_type({"", field.type, field.elements, false}) : field.type.name()) +
              " " + field.name + ";\n";
    }
    const std::string prefix = type.name == "In" ? "i" : type.name == "Out" ? "o" : "?";
    if (std::find(nested_.begin(), nested_.end(), prefix) != nested_.end()) text += "    T0 nested;\n";
    return text + "  };\n";
  }
  static std::string array_type(const Array& a) {
    return "std::array<" + a.type.name() + ", " + to_string(a.elements) + ">";
  }
  std::string initialiser(const Array& a) {
    std::string text = "{{";
    for (int n = 0; n < a.elements; ++n) text += (n ? ", " : "") + typed_literal(a.type);
    return text + "}}";
  }

  void add_fields(const std::string& object, const std::vector<Field>& fields, bool writable,
                  std::vector<Variable>& variables) {
    for (const Field& field : fields) {
      if (field.name == "valid") continue;
      if (!field.elements) variables.push_back({object + "." + field.name, field.type, writable});
      for (int n = 0; n < field.elements; ++n)
        variables.push_back({object + "." + field.name + "[" + to_string(n) + "]", field.type, writable});
    }
  }
  void add_inputs(const std::string& object, const std::vector<Field>& fields) {
    add_fields(object, fields, false, inputs_);
    if (object == "in" && std::find(nested_.begin(), nested_.end(), "i") != nested_.end()) {
      add_fields("in.nested", structs_[0].fields, false, inputs_);
    }
  }

  // ---- literals and conversions ----
  std::string literal(Type type) {
    if (type.kind == Kind::boolean) return chance(50) ? "true" : "false";
    const int width = std::min(type.width, 62) - (type.is_signed() ? 1 : 0);
    std::uint64_t value = rng_.next() & ((std::uint64_t{1} << (1 + pick(std::max(1, width)))) - 1);
    value &= (std::uint64_t{1} << width) - 1;
    if (type.is_signed() && chance(40)) return "-" + to_string(value) + "LL";
    return to_string(value) + (value >> 31 ? "LL" : "");
  }
  std::string typed_literal(Type type) {
    return type.kind == Kind::boolean ? literal(type) : type.name() + "(" + literal(type) + ")";
  }

  std::string convert(const Expression& e, Type to) {
    if (e.type == to) return e.text;
    if (to.kind == Kind::boolean) return "(" + e.text + " != 0)";
    if (to.fixed()) return to.name() + "(" + e.text + ")";
    return "static_cast<" + to.name() + ">(" + e.text + (e.type.fixed() ? ".value())" : ")");
  }
  Expression fixed(const Expression& e) {
    if (e.type.fixed()) return e;
    const Type to = e.type.kind == Kind::boolean ? u(1) : e.type.is_signed() ? s(e.type.width) : u(e.type.width);
    return {convert(e, to), to};
  }
  Expression at_most(Expression e, int width) {
    e = fixed(e);
    if (e.type.width <= width) return e;
    const Type to{e.type.kind, width};
    return {convert(e, to), to};
  }
  Expression as_u(Expression e, int width) { return {convert(fixed(e), u(width)), u(width)}; }

  // ---- expressions ----
  Expression variable() {
    std::vector<const Variable*> all;
    for (const auto* list : {&inputs_, &state_, &locals_, &locals_}) {
      for (const Variable& v : *list) {
        if (!pure_ || list == &locals_) all.push_back(&v);
      }
    }
    if (all.empty()) return {typed_literal(u(8)), u(8)};
    const Variable& v = *all[rng_.below(all.size())];
    return {v.name, v.type};
  }

  std::string index(int elements, int depth) {
    // A power of two: an index that wide cannot leave the array.
    const int bits = log2_ceil(elements);
    return as_u(any(depth), bits).text + ".value()";
  }

  Expression any(int depth) {
    if (depth <= 0 || budget_-- <= 0) {
      if (chance(20)) {
        const Type type = leaf_type();
        return {typed_literal(type), type};
      }
      return variable();
    }
    switch (pick(24)) {
      case 0:
      case 1:
      case 2:
        return arithmetic(chance(50) ? "+" : "-", depth);
      case 3:
        return arithmetic("*", depth);
      case 4:
      case 5: {
        const Expression a = as_unsigned(any(depth - 1)), b = as_unsigned(any(depth - 1));
        static const char* const kOps[] = {" & ", " | ", " ^ "};
        return {"(" + a.text + kOps[pick(3)] + b.text + ")", u(std::max(a.type.width, b.type.width))};
      }
      case 6: {
        const Expression a = fixed(any(depth - 1));
        if (chance(50)) return {"(~" + a.text + ")", a.type};
        const Expression b = at_most(a, 60);
        return {"(-" + b.text + ")", s(b.type.is_signed() ? std::max(2, b.type.width) + 1 : b.type.width + 1)};
      }
      case 7:
      case 8: {
        static const char* const kOps[] = {" == ", " != ", " < ", " > ", " <= ", " >= "};
        const Expression a = fixed(any(depth - 1));
        const Expression b = chance(30) ? Expression{typed_literal(a.type), a.type} : fixed(any(depth - 1));
        return {"(" + a.text + kOps[pick(6)] + b.text + ")", kBool};
      }
      case 9:
      case 10: {
        const Type type = value_type();
        return {"(" + condition(depth - 1) + " ? " + of(type, depth - 1) + " : " + of(type, depth - 1) + ")", type};
      }
      case 11: {
        const Expression a = fixed(any(depth - 1));
        if (chance(50)) return {a.text + ".bit(" + to_string(pick(a.type.width)) + ")", kBool};
        const int low = pick(a.type.width), high = low + pick(a.type.width - low);
        return {a.text + ".bits<" + to_string(high) + ", " + to_string(low) + ">()", u(high - low + 1)};
      }
      case 12: {
        const Expression a = at_most(any(depth - 1), 20), b = at_most(any(depth - 1), 20);
        if (chance(30))
          return {"cat(" + a.text + ", " + condition(depth - 1) + ", " + b.text + ")",
                  u(a.type.width + 1 + b.type.width)};
        return {"cat(" + a.text + ", " + b.text + ")", u(a.type.width + b.type.width)};
      }
      case 13: {
        const int k = pick(8);
        const Expression a = at_most(any(depth - 1), 56);
        if (chance(50)) return {"shl<" + to_string(k) + ">(" + a.text + ")", {a.type.kind, a.type.width + k}};
        return {"shr<" + to_string(k) + ">(" + a.text + ")", {a.type.kind, std::max(1, a.type.width - k)}};
      }
      case 14: {
        const Expression amount = as_u(any(depth - 1), 1 + pick(3));
        const Expression a = as_unsigned(at_most(any(depth - 1), 30));
        if (chance(50))
          return {"(" + a.text + " << " + amount.text + ")", u(a.type.width + (1 << amount.type.width) - 1)};
        return {"(" + a.text + " >> " + amount.text + ")", a.type};
      }
      case 15: {
        const Expression a = fixed(any(depth - 1));
        const int width = 1 + pick(a.type.width + 2);
        if (chance(60)) return {"sat<" + to_string(std::min(width, 64)) + ">(" + a.text + ")", u(std::min(width, 64))};
        return {"resize<" + to_string(std::clamp(width, 2, 64)) + ">(" + a.text + ")",
                {a.type.kind, std::clamp(width, 2, 64)}};
      }
      case 16: {
        const Type type = u(random_width());
        if (chance(30)) {
          const Expression a{of(s(12), depth - 1), s(12)};
          return {"abs(" + a.text + ")", u(12)};
        }
        return {std::string{"hls::"} + (chance(50) ? "min" : "max") + "(" + of(type, depth - 1) + ", " +
                    of(type, depth - 1) + ")",
                type};
      }
      case 17: {
        const std::int64_t low = rng_.between(-50, 20), high = low + rng_.between(0, 100);
        return {
            "std::clamp(" + of(s(12), depth - 1) + ", s<12>(" + to_string(low) + "), s<12>(" + to_string(high) + "))",
            s(12)};
      }
      case 18:
        if (!roms_.empty() && !pure_) {
          const Array& rom = one_of(roms_);
          return {rom.name + "[" + index(rom.elements, depth - 1) + "]", rom.type};
        }
        return builtin(depth);
      case 19:
        if (!arrays_.empty() && !pure_) {
          const Array& a = one_of(arrays_);
          return {a.name + "[" + index(a.elements, depth - 1) + "]", a.type};
        }
        return variable();
      case 20:
        if (!functions_.empty() && !pure_) {
          const Function& f = one_of(functions_);
          std::string text = f.name + "(";
          for (std::size_t n = 0; n < f.parameters.size(); ++n)
            text += (n ? ", " : "") + of(f.parameters[n], depth - 1);
          return {text + ")", f.result};
        }
        return variable();
      case 21:
        return builtin(depth);
      case 22: {
        // A lambda with an early return.
        const Type type = leaf_type();
        return {"([&]() -> " + type.name() + " { if (" + condition(depth - 1) + ") return " + of(type, depth - 1) +
                    "; return " + of(type, depth - 1) + "; }())",
                type};
      }
      default:
        return variable();
    }
  }

  Expression as_unsigned(const Expression& e) {
    const Expression f = fixed(e);
    return f.type.kind == Kind::u ? f : Expression{convert(f, u(f.type.width)), u(f.type.width)};
  }

  Expression arithmetic(const std::string& op, int depth) {
    const int limit = op == "*" ? (chance(90) ? 10 : 30) : 60;
    const Expression a = at_most(any(depth - 1), limit), b = at_most(any(depth - 1), limit);
    const bool both_unsigned = !a.type.is_signed() && !b.type.is_signed();
    const std::string text = "(" + a.text + " " + op + " " + b.text + ")";
    if (op == "*") return {text, {both_unsigned ? Kind::u : Kind::s, a.type.width + b.type.width}};
    if (both_unsigned) return {text, {op == "+" ? Kind::u : Kind::s, std::max(a.type.width, b.type.width) + 1}};
    return {text, s(std::max(a.type.signed_width(), b.type.signed_width()) + 1)};
  }

  /// Arithmetic on the language's own integers; signed operands are kept so small that nothing overflows.
  Expression builtin(int depth) {
    switch (pick(5)) {
      case 0: {
        const Type type{Kind::builtin_signed, 32};
        static const char* const kOps[] = {" + ", " - ", " * "};
        const auto operand = [&] { return convert({of(s(14), depth - 1), s(14)}, type); };
        return {"(" + operand() + kOps[pick(3)] + operand() + ")", type};
      }
      case 1: {
        const Type type{Kind::builtin_unsigned, chance(80) ? 32 : 64};
        static const char* const kOps[] = {" + ", " - ", " & ", " | ", " ^ "};
        return {"(" + of(type, depth - 1) + kOps[pick(5)] + of(type, depth - 1) + ")", type};
      }
      case 2: {
        const Type type{Kind::builtin_unsigned, 32};
        const std::string amount = as_u(any(depth - 1), 5).text + ".value()";
        return {"(" + of(type, depth - 1) + (chance(50) ? " << " : " >> ") + amount + ")", type};
      }
      case 3: {
        const Type type{Kind::builtin_unsigned, 32};
        return {"u<6>(std::popcount(" + of(type, depth - 1) + "))", u(6)};
      }
      default: {
        const Type type{Kind::builtin_unsigned, 16};
        // Promoted to int: 16 bits cannot overflow it.
        return {"static_cast<std::uint16_t>(" + of(type, depth - 1) + (chance(50) ? " + " : " - ") +
                    of(type, depth - 1) + ")",
                type};
      }
    }
  }

  std::string of(Type type, int depth) { return convert(any(depth), type); }
  std::string condition(int depth) {
    if (chance(50)) {
      for (int attempt = 0; attempt < 4; ++attempt) {
        const Expression e = variable();
        if (e.type == kBool) return e.text;
      }
    }
    return of(kBool, depth);
  }

  // ---- functions ----
  void function(int n) {
    Function f{"f" + to_string(n), leaf_type(), {}};
    const int parameters = 1 + pick(3);
    const auto outer_locals = std::exchange(locals_, {});
    std::string text;
    for (int k = 0; k < parameters; ++k) {
      f.parameters.push_back(value_type());
      locals_.push_back({"p" + to_string(k), f.parameters.back(), false});
      text += (k ? ", " : "") + f.parameters.back().name() + " p" + to_string(k);
    }
    pure_ = true;
    budget_ = 20;
    text = "  static " + f.result.name() + " " + f.name + "(" + text + ") {\n";
    if (chance(40)) text += "    if (" + condition(1) + ") return " + of(f.result, 2) + ";\n";
    if (chance(30)) {
      const Type type = u(4 + pick(8));
      text += "    " + type.name() + " sum{};\n    for (int i = 0; i < " + to_string(2 + pick(5)) +
              "; ++i) {\n      if (p0" +
              (f.parameters[0].kind == Kind::boolean ? ""
               : f.parameters[0].fixed()             ? ".bit(i % " + to_string(f.parameters[0].width) + ")"
                                                     : " != 0") +
              ") sum += " + of(u(3), 1) + ";\n    }\n";
      locals_.push_back({"sum", type, false});
    }
    text += "    return " + of(f.result, 3) + ";\n  }\n";
    members_ += text;
    pure_ = false;
    locals_ = outer_locals;
    functions_.push_back(f);
  }

  // ---- memories ----
  void ram(int n) {
    const std::string id = to_string(n), name = "ram" + id + "_", address = "x" + id;
    // The word.
    std::string word;
    Type word_type = leaf_type();
    int word_struct = -1;
    if (!structs_.empty() && chance(30)) {
      word_struct = pick(static_cast<int>(structs_.size()));
      word = structs_[static_cast<std::size_t>(word_struct)].name;
    } else {
      word = word_type.name();
    }
    const auto word_expression = [this, word_struct, word_type, word, id](int depth) {
      if (word_struct < 0) return of(word_type, depth);
      return struct_expression(word_struct, depth);
    };
    const int log_depth = 2 + pick(5);
    int words = 1 << log_depth;
    const int idiom = pick(6);
    if (idiom == 0 && chance(50)) words -= pick(words / 2);  // any depth
    const int bits = log2_ceil(words);
    const std::string counter = "u<" + to_string(bits) + ">";
    const auto distance_up_to = [&](int limit) { return chance(40) ? limit : 2 + pick(std::max(1, limit - 1)); };
    int distance = 2;
    std::string begin = "    " + name + ".begin_step();\n", member;
    std::function<std::string()> end;
    const std::string data = "d" + id;
    const std::string next =
        "    const " + counter + " " + address + " = " + address + "_;\n    " + address + "_ = " +
        ((1 << bits) == words && chance(50) ? counter + "(" + address + " + lit<1>());\n"
                                            : address + " == " + to_string(words - 1) + " ? " + counter +
                                                  "() : " + counter + "(" + address + " + lit<1>());\n");
    const std::string guard = chance(30) ? "in_" + id : "";  // accesses only in some steps
    const auto guarded = [guard](const std::string& statement) {
      return guard.empty() ? "    " + statement + "\n" : "    if (" + guard + ") " + statement + "\n";
    };
    switch (idiom) {
      case 0:
      case 1: {  // a line buffer: read, and write the same word later in the step
        distance = distance_up_to(words);
        member = "  " + counter + " " + address + "_{};\n";
        if (chance(30)) {
          // Restarted by the data, but not before the first words are DISTANCE steps old.
          begin += "    if (" + deferred(1) + " && " + address + "_ >= " + to_string(std::min(distance, words - 1)) +
                   " && " + to_string(distance) + " < " + to_string(words) + ") " + address + "_ = " + counter +
                   "();\n";
        }
        begin += next;
        begin += "    " + word + " " + data + "{};\n" + guarded(data + " = " + name + ".read(" + address + ");");
        end = [=, this] {
          std::string text = (chance(30) ? "    if (" + condition(2) + ")\n  " : "") +
                             guarded(name + ".write(" + address + ", " + word_expression(3) + ");");
          if (chance(20))
            text += "    if (" + condition(1) + ") {\n  " +
                    guarded(name + ".write(" + address + ", " + word_expression(2) + ");") + "    }\n";
          return text;
        };
        break;
      }
      case 2: {  // read here, write a constant number of words ahead
        const int ahead = 2 + pick(words - 3);
        distance = distance_up_to(std::min(ahead, words - ahead));
        if (distance > std::min(ahead, words - ahead)) distance = std::min(ahead, words - ahead);
        if (words - ahead < 2) return ram(n);
        member = "  " + counter + " " + address + "_{" + to_string(pick(words)) + "};\n";
        begin += next + "    " + word + " " + data + "{};\n" + guarded(data + " = " + name + ".read(" + address + ");");
        end = [=] {
          return guarded(name + ".write(" + counter + "(" + address + " + " + counter + "(" + to_string(ahead) +
                         ")), " + word_expression(3) + ");");
        };
        break;
      }
      case 3: {  // any address, but none of those accessed less than DISTANCE steps ago
        distance = 2 + pick(4);
        const std::string recent = "recent" + id + "_", clash = "clash" + id;
        member = "  std::array<" + counter + ", " + to_string(distance - 1) + "> " + recent +
                 "{};\n  std::array<bool, " + to_string(distance - 1) + "> used" + id + "_{};\n";
        begin += "    const " + counter + " " + address + " = " + deferred_of(u(bits)) + ";\n    bool " + clash +
                 " = false;\n    for (int i = 0; i < " + to_string(distance - 1) + "; ++i) " + clash + " = " + clash +
                 " || (used" + id + "_[i] && " + recent + "[i] == " + address + ");\n" +
                 "    for (int i = " + to_string(distance - 2) + "; i > 0; --i) {\n      " + recent +
                 "[i] = " + recent + "[i - 1];\n      used" + id + "_[i] = used" + id + "_[i - 1];\n    }\n    " +
                 recent + "[0] = " + address + ";\n    used" + id + "_[0] = !" + clash + ";\n    " + word + " " + data +
                 "{};\n    if (!" + clash + ") " + data + " = " + name + ".read(" + address + ");\n";
        end = [=, this] {
          return "    if (!" + clash + (chance(40) ? " && " + condition(2) : "") + ") " + name + ".write(" + address +
                 ", " + word_expression(3) + ");\n";
        };
        words = 1 << bits;
        break;
      }
      case 4: {  // exclusive branches with different addresses
        const std::string other = counter + "(" + address + " ^ " + counter + "(" + to_string(words / 2) + "))";
        distance = distance_up_to(words / 2);
        if (distance > words / 2) distance = words / 2;
        member = "  " + counter + " " + address + "_{};\n";
        begin += next + "    " + word + " " + data + "{};\n    if (" + deferred(1) + ") {\n      " + data + " = " +
                 name + ".read(" + address + ");\n    } else {\n      " + data + " = " + name + ".read(" + other +
                 ");\n    }\n";
        end = [=, this] {
          if (chance(50))
            return "    " + name + ".write(" + condition(2) + " ? " + address + " : " + other + ", " +
                   word_expression(3) + ");\n";
          return "    if (" + condition(2) + ") {\n      " + name + ".write(" + address + ", " + word_expression(2) +
                 ");\n    } else {\n      " + name + ".write(" + other + ", " + word_expression(2) + ");\n    }\n";
        };
        break;
      }
      default: {  // written first, then read: forwarded
        distance = distance_up_to(words);
        member = "  " + counter + " " + address + "_{};\n";
        const bool sometimes = chance(60);
        begin += next + (sometimes ? "    if (" + deferred(1) + ") " : "    ") + name + ".write(" + address + ", " +
                 deferred_word(word_expression) + ");\n    " + word + " " + data + " = " + name + ".read(" + address +
                 ");\n";
        end = [=, this] {
          if (chance(50)) return std::string{};
          return "    if (" + condition(2) + ") " + name + ".write(" + address + ", " + word_expression(2) + ");\n";
        };
        break;
      }
    }
    distance = std::max(2, distance);
    if (!guard.empty()) begin = "    const bool " + guard + " = " + deferred(1) + ";\n" + begin;
    members_ += member + "  RAM<" + word + ", " + to_string(words) + ", " + to_string(distance) + "> " + name + ";\n";
    rams_.push_back({begin, end, data, word_type, word_struct});
  }

  /// Addresses and enables of memories: of inputs and controls only.
  std::string deferred(int depth) { return deferred_of(kBool, depth); }
  std::string deferred_of(Type type, int depth = 2) {
    budget_ = 12;
    const auto locals = std::exchange(locals_, {});
    const auto state = std::exchange(state_, controls_);
    const auto arrays = std::exchange(arrays_, {});
    const std::string text = of(type, depth);
    locals_ = locals;
    state_ = state;
    arrays_ = arrays;
    return text;
  }
  /// A word written before the first read of the step: of what exists at that place.
  template <class F>
  std::string deferred_word(F&& word_expression) {
    budget_ = 12;
    const auto locals = std::exchange(locals_, {});
    const std::string text = word_expression(2);
    locals_ = locals;
    return text;
  }

  std::string struct_expression(int type, int depth) {
    const Struct& description = structs_[static_cast<std::size_t>(type)];
    std::vector<std::string> same;
    for (const auto* list : {&struct_state_, &struct_locals_}) {
      for (const StructVariable& v : *list) {
        if (v.type == type) same.push_back(v.name);
      }
    }
    if (!same.empty() && chance(40)) return one_of(same);
    std::string text = description.name + "{";
    for (std::size_t n = 0; n < description.fields.size(); ++n) {
      const Field& field = description.fields[n];
      if (n) text += ", ";
      if (!field.elements) {
        text += of(field.type, depth - 1);
        continue;
      }
      text += "{{";
      for (int k = 0; k < field.elements; ++k) text += (k ? ", " : "") + of(field.type, depth - 2);
      text += "}}";
    }
    return text + "}";
  }

  // ---- statements ----
  std::string statements(int count, int depth, const std::string& indent) {
    std::string text;
    const auto locals = locals_;
    const auto struct_locals = struct_locals_;
    for (int n = 0; n < count; ++n) {
      budget_ = 25;
      text += statement(depth, indent);
    }
    if (depth < kDepth) {  // the names of an inner block end with it
      locals_ = locals;
      struct_locals_ = struct_locals;
    }
    return text;
  }

  std::string assignment(const std::string& indent) {
    std::vector<const Variable*> targets;
    for (const auto* list : {&state_, &locals_, &outputs_}) {
      for (const Variable& v : *list) {
        if (v.writable) targets.push_back(&v);
      }
    }
    const Variable& v = *targets[rng_.below(targets.size())];
    if (v.type.fixed() && chance(30))
      return indent + v.name + (chance(60) ? " += " : " -= ") + fixed(any(3)).text + ";\n";
    return indent + v.name + " = " + of(v.type, 4) + ";\n";
  }

  std::string statement(int depth, const std::string& indent) {
    const std::string inner = indent + "  ";
    switch (pick(depth > 0 ? 15 : 6)) {
      case 0:
      case 1: {
        const Variable v{"v" + to_string(names_++), value_type(), chance(50)};
        const std::string text =
            indent + (v.writable ? "" : "const ") + v.type.name() + " " + v.name + " = " + of(v.type, 4) + ";\n";
        locals_.push_back(v);
        return text;
      }
      case 2:
      case 3:
      case 4:
        return assignment(indent);
      case 5:
        if (!arrays_.empty()) {
          const Array& a = one_of(arrays_);
          return indent + a.name + "[" + index(a.elements, 2) + "] = " + of(a.type, 3) + ";\n";
        }
        return assignment(indent);
      case 6:
      case 7: {
        std::string text = indent + "if (" + condition(3) + ") {\n" + statements(1 + pick(3), depth - 1, inner);
        if (chance(40))
          text += indent + "} else if (" + condition(2) + ") {\n" + statements(1 + pick(2), depth - 1, inner);
        if (chance(50)) text += indent + "} else {\n" + statements(1 + pick(3), depth - 1, inner);
        return text + indent + "}\n";
      }
      case 8: {
        const int bits = 1 + pick(3);
        std::string text = indent + "switch (" + as_u(any(3), bits).text + ".value()) {\n";
        for (int value = 0; value < (1 << bits); ++value) {
          if (!chance(60)) continue;
          text += inner + "case " + to_string(value) + ":\n" + statement_block(depth, inner + "  ");
          if (!chance(15)) text += inner + "  break;\n";  // else falls through
        }
        text += inner + "default:\n" + statement_block(depth, inner + "  ") + inner + "  break;\n";
        return text + indent + "}\n";
      }
      case 9:
      case 10: {  // a counted loop over a sum, perhaps left early
        const std::string i = "i" + to_string(names_++), sum = "v" + to_string(names_++);
        const Type type = chance(70) ? u(6 + pick(10)) : s(6 + pick(10));
        std::string text = indent + type.name() + " " + sum + " = " + of(type, 2) + ";\n" + indent + "for (int " + i +
                           " = 0; " + i + " < " + to_string(2 + pick(6)) + "; ++" + i + ") {\n";
        locals_.push_back({sum, type, true});
        if (chance(30)) text += inner + "if (" + of(kBool, 2) + ") " + (chance(50) ? "break" : "continue") + ";\n";
        if (!arrays_.empty() && chance(60)) {
          const Array& a = one_of(arrays_);
          const std::string element = a.name + "[" + i + " % " + to_string(a.elements) + "]";
          text += inner + sum + " += " + fixed({element, a.type}).text + ";\n";
          if (chance(30)) text += inner + element + " = " + of(a.type, 2) + ";\n";
        } else {
          text += inner + sum + (chance(70) ? " += " : " -= ") + fixed(any(2)).text + ";\n";
        }
        if (chance(30))
          text += inner + "if (" + sum + " > " + typed_literal(type) + ") " + sum + " -= " + i_expression(i) + ";\n";
        return text + indent + "}\n";
      }
      case 11:
        if (shift_register_.elements) {
          const Array& a = shift_register_;
          return indent + "for (int i = " + to_string(a.elements - 1) + "; i > 0; --i) " + a.name + "[i] = " + a.name +
                 "[i - 1];\n" + indent + a.name + "[0] = " + of(a.type, 3) + ";\n";
        }
        return assignment(indent);
      case 12:
        if (!structs_.empty()) {
          if (!struct_state_.empty() && chance(50))
            return indent + struct_state_[0].name + " = " + struct_expression(struct_state_[0].type, 3) + ";\n";
          const int type = pick(static_cast<int>(structs_.size()));
          const StructVariable v{"w" + to_string(names_++), type};
          const std::string text = indent + structs_[static_cast<std::size_t>(type)].name + " " + v.name + " = " +
                                   struct_expression(type, 3) + ";\n";
          struct_locals_.push_back(v);
          add_fields(v.name, structs_[static_cast<std::size_t>(type)].fields, true, locals_);
          return text;
        }
        return assignment(indent);
      case 13:
        if (mode_) {
          return indent + "switch (mode_) {\n" + inner + "case Mode::idle: if (" + condition(2) +
                 ") mode_ = Mode::run; break;\n" + inner + "case Mode::run:\n" + statement_block(depth, inner + "  ") +
                 inner + "  if (" + condition(2) + ") mode_ = " + condition(1) + " ? Mode::hold : Mode::idle;\n" +
                 inner + "  break;\n" + inner + "case Mode::hold: mode_ = Mode::idle; break;\n" + indent + "}\n";
        }
        return assignment(indent);
      default:
        if (chance(35) && returns_++ < 2) return indent + "if (" + condition(3) + ") return out;\n";
        return assignment(indent);
    }
  }
  std::string i_expression(const std::string& i) { return "u<4>(" + i + ")"; }
  std::string statement_block(int depth, const std::string& indent) {
    return indent + "{\n" + statements(1 + pick(2), depth - 1, indent + "  ") + indent + "}\n";
  }

  std::string step_body() {
    std::string text = "    Out out{};\n";
    add_fields("out", out_, true, outputs_);
    if (std::find(nested_.begin(), nested_.end(), "o") != nested_.end())
      add_fields("out.nested", structs_[0].fields, true, outputs_);
    const bool has_valid = std::any_of(out_.begin(), out_.end(), [](const Field& f) { return f.name == "valid"; });
    if (has_valid) text += "    out.valid = true;\n";
    if (shift_register_.elements) {
      for (int n = 0; n < shift_register_.elements; ++n) {
        if (chance(50))
          state_.push_back({shift_register_.name + "[" + to_string(n) + "]", shift_register_.type, false});
      }
    }
    for (const StructVariable& v : struct_state_)
      add_fields(v.name, structs_[static_cast<std::size_t>(v.type)].fields, true, state_);
    text += control_updates_;
    for (const Ram& ram : rams_) {
      text += ram.begin;
      if (ram.word_struct >= 0) {
        struct_locals_.push_back({ram.data, ram.word_struct});
        add_fields(ram.data, structs_[static_cast<std::size_t>(ram.word_struct)].fields, true, locals_);
      } else {
        locals_.push_back({ram.data, ram.word_type, true});
      }
    }
    text += statements(3 + pick(8), kDepth, "    ");
    for (const Ram& ram : rams_) {
      budget_ = 25;
      text += ram.end();
    }
    if (chance(50)) text += statements(1 + pick(3), kDepth, "    ");
    for (const Variable& v : outputs_) {
      budget_ = 25;
      if (chance(75))
        text += "    " + v.name + (v.type.fixed() && chance(20) ? " += " + fixed(any(3)).text : " = " + of(v.type, 4)) +
                ";\n";
    }
    if (has_valid) text += "    out.valid = " + condition(3) + (chance(70) ? " || " + of(kBool, 0) : "") + ";\n";
    return text + "    return out;\n";
  }

  struct Ram {
    std::string begin;
    std::function<std::string()> end;
    std::string data;
    Type word_type;
    int word_struct;
  };

  static constexpr int kDepth = 3;
  std::uint64_t seed_;
  Rng rng_;
  int budget_ = 0, names_ = 0, returns_ = 0;
  bool pure_ = false, mode_ = false;
  std::vector<Struct> structs_;
  std::vector<std::string> nested_;  ///< prefixes of In and Out that hold a struct
  std::vector<Field> in_, out_, config_;
  std::vector<Variable> inputs_, state_, locals_, outputs_;
  std::vector<Array> arrays_, roms_;
  Array shift_register_;
  std::vector<StructVariable> struct_state_, struct_locals_;
  std::vector<Function> functions_;
  std::vector<Ram> rams_;
  std::vector<Variable> controls_;
  std::string members_, control_updates_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: random_program_generator SEED\n";
    return 2;
  }
  std::cout << Generator{std::strtoull(argv[1], nullptr, 0)}.program();
}
