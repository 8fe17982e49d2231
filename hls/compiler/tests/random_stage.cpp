// SPDX-License-Identifier: Apache-2.0
#include "random_stage.hpp"

#include <random>
#include <sstream>
#include <vector>

namespace hlsc::test {

namespace {

class Generator {
 public:
  Generator(std::uint64_t seed, bool schedulable) : random_(seed), schedulable_(schedulable) {}

  std::string run() {
    std::ostringstream text;
    text << "#pragma once\n#include <algorithm>\n#include <array>\n#include <bit>\n#include <cstdint>\n#include "
            "<cstdlib>\n"
         << "#include <horopter/hls/int.hpp>\n#include <horopter/hls/ram.hpp>\n"
         << "namespace random_stage {\nusing horopter::hls::RAM;\nusing horopter::hls::s;\nusing horopter::hls::u;\n"
         << "struct Pair { u<" << width(12) << "> a; s<" << width(12) << "> b; bool c; };\n"
         << "inline constexpr std::array<std::int16_t, 23> kTable{";
    for (int i = 0; i < 23; ++i) text << (i ? ", " : "") << static_cast<int>(random_() % 4001) - 2000;
    text << "};\nstruct Base { std::uint16_t in_base = " << random_() % 65536
         << "; int bump(int x) { in_base = static_cast<std::uint16_t>(in_base + x); return in_base; } };\n";
    text << "class Stage : Base {\n public:\n";
    text << "  struct In { u<" << width(16) << "> x; s<" << width(16) << "> y; bool flag; Pair pair; std::array<u<"
         << width(9) << ">, 4> items; std::int32_t wide; };\n";
    text << "  struct Config { u<5> level; s<7> offset; };\n";
    text << "  struct Out { bool valid; std::uint32_t r0; std::int64_t r1; u<13> r2; s<11> r3; Pair pair; std::uint8_t "
            "r4; };\n";
    locals_ = {"v0", "v1", "v2", "v3", "v4", "v5"};
    text << "  Out step(const In& in, const Config& config) {\n"
         << "    Out out{};\n    out.valid = true;\n"
         << "    std::uint32_t v0 = in.x.value();\n    std::int32_t v1 = in.y.value();\n    std::uint64_t v2 = "
            "static_cast<std::uint32_t>(in.wide);\n"
         << "    std::int64_t v3 = in.wide;\n    std::uint8_t v4 = static_cast<std::uint8_t>(in.items[0].value());\n   "
            " std::int16_t v5 = static_cast<std::int16_t>(config.offset.value());\n"
         << "    std::array<std::uint16_t, 8> local{};\n    Pair pair = in.pair;\n"
         << "    const auto fold = [&](auto x) { v0 ^= static_cast<std::uint32_t>(x); return v0 + 3; };\n";
    text << memory_access();
    const int count = 4 + static_cast<int>(random_() % 8);
    for (int i = 0; i < count; ++i) text << statement(2, "    ");
    text << "    out.r0 = v0 ^ total_;\n    out.r1 = v3 + v1;\n    out.r2 = u<13>(v2 + registers_[" << random_() % 8
         << "]);\n"
         << "    out.r3 = s<11>(v5 - v1 / 4);\n    out.pair = pairs_[1];\n    out.r4 = static_cast<std::uint8_t>(v4 + "
            "local[3] + remembered_.value());\n"
         << "    return out;\n  }\n";
    text << " private:\n  std::uint32_t total_ = " << random_() % 1000
         << ";\n  std::array<std::uint16_t, 8> registers_{1, 2, 3};\n"
         << "  std::array<Pair, 3> pairs_{};\n  s<" << width(20)
         << "> remembered_ {-7};\n  int counter_ = 0;\n  bool toggle_ = true;\n"
         << "  std::array<std::array<u<5>, 3>, 4> grid_{};\n  RAM<Pair, 13, 13> memory_;\n  u<4> place_;\n  RAM<u<7>, "
            "32, 1> loose_;\n};\n}\n";
    return text.str();
  }

 private:
  std::uint64_t pick(std::uint64_t n) { return random_() % n; }
  int width(int most) { return 1 + static_cast<int>(pick(static_cast<std::uint64_t>(most))); }
  const std::string& local() { return locals_[pick(locals_.size())]; }

  static std::string u64(const std::string& x) { return "static_cast<std::uint64_t>(" + x + ")"; }
  static std::string u32(const std::string& x) { return "static_cast<std::uint32_t>(" + x + ")"; }
  static std::string i32(const std::string& x) { return "static_cast<std::int32_t>(" + x + ")"; }

  std::string leaf() {
    switch (pick(16)) {
      case 0:
        return "in.x.value()";
      case 1:
        return "in.y.value()";
      case 2:
        return "(in.flag ? 1 : 0)";
      case 3:
        return "in.pair.a.value()";
      case 4:
        return "in.pair.b.value()";
      case 5:
        return "in.items[" + u32(local()) + " & 3].value()";
      case 6:
        return "config.level.value()";
      case 7:
        return "total_";
      case 8:
        return "registers_[" + u32(local()) + " % 8]";
      case 9:
        return "pair.b.value()";
      case 10:
        return "local[" + std::to_string(pick(8)) + "]";
      case 11:
        return "kTable[" + u32(local()) + " % 16 + " + std::to_string(pick(8)) + "]";
      case 12:
        return "grid_[" + u32(local()) + " & 3][std::min(2U, " + u32(local()) + " & 3)].value()";
      case 13:
        return std::to_string(static_cast<int>(pick(2000)) - 1000);
      default:
        return local();
    }
  }

  /// Of any integer type; no overflow of signed types.
  std::string expression(int depth) {
    if (depth == 0) return leaf();
    const std::string a = expression(depth - 1), b = expression(depth - 1);
    const bool wide = pick(3) == 0;
    const auto cast = [&](const std::string& x) { return wide ? u64(x) : u32(x); };
    switch (pick(24)) {
      case 0:
        return "(" + cast(a) + " + " + cast(b) + ")";
      case 1:
        return "(" + cast(a) + " - " + cast(b) + ")";
      case 2:
        return "(" + cast(a) + " * " + cast(b) + ")";
      case 3:
        return "(" + cast(a) + " & " + cast(b) + ")";
      case 4:
        return "(" + cast(a) + " | " + cast(b) + ")";
      case 5:
        return "(" + cast(a) + " ^ " + cast(b) + ")";
      case 6:
        return "(" + cast(a) + " << (" + u32(b) + " & " + (wide ? "63" : "31") + "))";
      case 7:
        return "(" + cast(a) + " >> (" + u32(b) + " & " + (wide ? "63" : "31") + "))";
      case 8:
        return "(" + i32(a) + " >> (" + u32(b) + " & 31))";
      case 9:
        return "(" + i32(a) + " / " + std::to_string(1 << pick(8)) + ")";
      case 10:
        return "(" + i32(a) + " % " + std::to_string(1 << pick(8)) + ")";
      case 11:
        return "(" + condition(depth - 1) + " ? " + i32(a) + " : " + i32(b) + ")";
      case 12:
        return "std::min(" + i32(a) + ", " + i32(b) + ")";
      case 13:
        return "std::max(" + u32(a) + ", " + u32(b) + ")";
      case 14:
        return "std::clamp(" + i32(a) + ", -100, " + std::to_string(pick(300)) + ")";
      case 15:
        return "std::abs(static_cast<std::int32_t>(static_cast<std::int16_t>(" + a + ")))";
      case 16:
        return "std::popcount(" + cast(a) + ")";
      case 17:
        return "std::countl_zero(" + cast(a) + ")";
      case 18:
        return "std::countr_zero(" + u32(a) + ")";
      case 19:
        return "std::rotl(" + cast(a) + ", static_cast<int>(" + u32(b) + " & 31))";
      case 20:
        return "(" + cast(a) + " * " + std::to_string(pick(1000)) + ")";
      case 21:
        return "static_cast<std::int8_t>(" + a + ")";
      case 22:
        return "s<" + std::to_string(width(30)) + ">(" + a + ").value()";
      default:
        return "u<" + std::to_string(width(60)) + ">(" + a + ").value()";
    }
  }

  std::string condition(int depth) {
    const std::string a = expression(depth), b = expression(depth);
    switch (pick(9)) {
      case 0:
        return "(" + i32(a) + " < " + i32(b) + ")";
      case 1:
        return "(" + u32(a) + " <= " + u32(b) + ")";
      case 2:
        return "(" + u64(a) + " > " + u64(b) + ")";
      case 3:
        return "(" + u32(a) + " % 4 == " + u32(b) + " % 4)";
      case 4:
        return "(" + i32(a) + " != " + i32(b) + ")";
      case 5:
        return "in.flag";
      case 6:
        return "toggle_";
      case 7:
        return "((" + u32(a) + " & 1) != 0 && " + i32(b) + " >= 0)";
      default:
        return "(in.pair.c || " + i32(a) + " > " + std::to_string(pick(100)) + ")";
    }
  }

  std::string assign(const std::string& indent) {
    const std::string e = expression(2);
    switch (pick(13)) {
      case 0:
        return indent + "total_ = " + u32(e) + ";\n";
      case 1:
        return indent + "registers_[" + u32(local()) + " % 8] = static_cast<std::uint16_t>(" + e + ");\n";
      case 2:
        return indent + "pairs_[" + u32(local()) + " % 4 == 3 ? 0 : " + u32(local()) + " % 2].b = s<9>(" + e +
               ").value();\n";
      case 3:
        return indent + "pairs_[" + std::to_string(pick(3)) + "] = pair;\n";
      case 4:
        return indent + "pair.a = decltype(pair.a)(" + e + ");\n";
      case 5:
        return indent + "remembered_ += s<9>(" + e + ");\n";
      case 6:
        return indent + "local[" + u32(local()) + " & 7] ^= static_cast<std::uint16_t>(" + e + ");\n";
      case 7:
        return indent + "toggle_ = " + condition(1) + ";\n";
      case 8:
        return indent + "grid_[" + std::to_string(pick(4)) + "][" + u32(local()) + " % 2] = u<5>(" + e + ");\n";
      case 9:
        return indent + "v2 += " + u64("fold(" + e + ")") + ";\n";
      case 10:
        return indent + "v5 = static_cast<std::int16_t>(bump(static_cast<std::int16_t>(" + e + ")));\n";
      default: {
        static const char* const kTypes[] = {"std::uint32_t", "std::int32_t", "std::uint64_t",
                                             "std::int64_t",  "std::uint8_t", "std::int16_t"};
        const std::size_t i = pick(6);
        return indent + locals_[i] + " = static_cast<" + kTypes[i] + ">(" + e + ");\n";
      }
    }
  }

  std::string block(int depth, const std::string& indent) {
    std::string text;
    const auto count = 1 + pick(3);
    for (std::uint64_t i = 0; i < count; ++i) text += statement(depth, indent);
    return text;
  }

  std::string statement(int depth, const std::string& indent) {
    if (depth == 0) return assign(indent);
    const std::string inner = indent + "  ";
    switch (pick(12)) {
      case 0:
      case 1:
        return indent + "if (" + condition(1) + ") {\n" + block(depth - 1, inner) + indent + "}\n";
      case 2:
      case 3:
        return indent + "if (" + condition(1) + ") {\n" + block(depth - 1, inner) + indent + "} else {\n" +
               block(depth - 1, inner) + indent + "}\n";
      case 4: {
        const std::string i = "i" + std::to_string(++loops_);
        std::string text =
            indent + "for (unsigned " + i + " = 0; " + i + " < " + std::to_string(2 + pick(4)) + "; ++" + i + ") {\n";
        if (pick(2) == 0) text += inner + "if (" + condition(1) + ") " + (pick(2) == 0 ? "break" : "continue") + ";\n";
        text += inner + "v0 += " + i + " * 5;\n" + block(depth - 1, inner) + indent + "}\n";
        return text;
      }
      case 5: {
        std::string text = indent + "switch (" + u32(local()) + " & 7) {\n";
        for (int i = 0; i < 4; ++i) {
          text += inner + "case " + std::to_string(i) + ":\n" + block(depth - 1, inner + "  ");
          if (pick(4) != 0) text += inner + "  break;\n";
        }
        return text + inner + "default:\n" + block(depth - 1, inner + "  ") + indent + "}\n";
      }
      case 6: {
        const std::string p = "p" + std::to_string(++loops_);
        return indent + "{\n" + inner + "std::uint16_t* " + p + " = " + condition(1) + " ? &registers_[" +
               std::to_string(pick(8)) + "] : &local[" + u32(local()) + " % 8];\n" + inner + "*" + p +
               " = static_cast<std::uint16_t>(*" + p + " + " + expression(1) + ");\n" + indent + "}\n";
      }
      case 7:
        if (pick(3) != 0) return assign(indent);
        return indent + "if (" + condition(1) + ") {\n" + block(depth - 1, inner) + inner + "out.r0 = v0;\n" + inner +
               "out.valid = " + condition(1) + ";\n" + inner + "return out;\n" + indent + "}\n";
      case 8:
        return indent + "std::swap(pairs_[" + std::to_string(pick(3)) + "], pairs_[" + std::to_string(pick(3)) +
               "]);\n";
      case 9:
        return indent + "for (std::size_t i = 7; i > 0; --i) registers_[i] = registers_[i - 1];\n" + indent +
               "registers_[0] = static_cast<std::uint16_t>(" + expression(1) + ");\n";
      default:
        return assign(indent);
    }
  }

  /// Memories have rules, so their accesses come in known forms.
  std::string memory_access() {
    std::string text = "    memory_.begin_step();\n    loose_.begin_step();\n";
    text += "    place_ = place_.value() == 12 ? u<4>(0) : u<4>(place_.value() + 1);\n";
    switch (pick(4)) {
      case 0:
        text += "    const Pair old = memory_.read(place_);\n    v0 += old.a.value();\n    v1 = " +
                i32("v1 ^ old.b.value()") + ";\n    memory_.write(place_, " +
                std::string(pick(2) == 0 ? "pair" : "Pair{old.a, decltype(old.b)(v1), in.flag}") + ");\n";
        break;
      case 1:
        text +=
            "    if (in.flag) memory_.write(place_, pair);\n    const Pair now = memory_.read(place_);\n    v4 = "
            "static_cast<std::uint8_t>(now.a.value() + now.c);\n";
        break;
      case 2:
        text += "    if (" + condition(1) +
                ") {\n      pair = memory_.read(place_);\n      memory_.write(place_, in.pair);\n    } else if "
                "(in.flag) {\n      memory_.write(place_, Pair{});\n    }\n";
        break;
      default:
        text +=
            "    memory_.write(place_, in.pair);\n    if (v0 % 2 == 0) memory_.write(place_, pairs_[0]);\n    pair = "
            "memory_.read(place_);\n";
        break;
    }
    if (schedulable_) return text;
    switch (pick(4)) {
      case 0:
        text += "    if (in.flag) {\n      v4 = loose_.read(" + u32(local()) +
                " % 32).value();\n    } else {\n      v4 ^= loose_.read(v0 & 31).value();\n    }\n";
        text += "    if (v4 & 1) loose_.write(v0 % 32, u<7>(v2));\n";
        break;
      case 1:
        text +=
            "    if (toggle_) loose_.write(in.x.value() & 31, u<7>(v1));\n    v0 += loose_.read(v4 & 31).value();\n";
        break;
      case 2:
        text +=
            "    switch (v0 & 3) {\n      case 0: loose_.write(1, u<7>(v2)); break;\n      case 1: loose_.write(v4 & "
            "31, u<7>(v0 >> 3)); break;\n      case 2: v1 = loose_.read(v4 & 31).value(); break;\n      default: v1 = "
            "loose_.read(1).value() * 3; break;\n    }\n";
        break;
      default:
        text +=
            "    if (in.flag) loose_.write(v4 % 32, u<7>(v0));\n    if (!in.flag) loose_.write(v0 % 32, u<7>(v4));\n   "
            " v5 = static_cast<std::int16_t>(v5 + loose_.read(v4 & 31).value());\n";
        break;
    }
    return text;
  }

  std::mt19937_64 random_;
  bool schedulable_;
  std::vector<std::string> locals_;
  int loops_ = 0;
};

}  // namespace

std::string random_stage(std::uint64_t seed, bool schedulable) { return Generator(seed, schedulable).run(); }

}  // namespace hlsc::test
