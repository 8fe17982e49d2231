// SPDX-License-Identifier: Apache-2.0
// What hlsc refuses, and what it says. Each stage is a file of its own, whose line of interest is marked in the test.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "twin.hpp"

using namespace hlsc::test;

namespace {

/// A stage around the body of `step` and some members; both begin a line of their own: the body's first line is 16, the
/// members' first line is 11.
std::string stage_text(const std::string& body, const std::string& members = "") {
  return "#pragma once\n"                                              // 1
         "#include <horopter/hls/int.hpp>\n"                           // 2
         "#include <horopter/hls/ram.hpp>\n"                           // 3
         "#include <array>\n"                                          // 4
         "using namespace horopter::hls;\n"                            // 5
         "int outside(int);\n"                                         // 6
         "class Stage {\n"                                             // 7
         " public:\n"                                                  // 8
         "  struct In { u<8> x, y; bool flag; };\n"                    // 9
         "  struct Out { u<8> z; };\n"                                 // 10
         + (members.empty() ? std::string("  \n") : members + "\n") +  // 11
         "  struct Word { u<8> a; };\n"                                // 12
         "  RAM<u<8>, 16, 4> memory_;\n"                               // 13
         "  Out step(const In& in) {\n"                                // 14
         "    Out out;\n"                                              // 15
         + body +
         "\n"  // 16
         "    return out;\n"
         "  }\n"
         "};\n";
}

std::string refused(const std::string& body, const std::string& members = "") {
  return error_of(stage_options(write_header("stage.hpp", stage_text(body, members)), "Stage"));
}

}  // namespace

TEST_CASE("the frame of these tests compiles", "[diagnostics]") { CHECK(refused("out.z = in.x;") == ""); }

TEST_CASE("loops whose length depends on data", "[diagnostics]") {
  CHECK(refused("int n = in.x.value() * 1000; while (n > 17) n = n ^ (n / 2 + in.y.value()); out.z = u<8>(n);") ==
        "stage.hpp:16: error: the number of iterations of this loop depends on data: it cannot be unrolled");
}

TEST_CASE("loops that are too long", "[diagnostics]") {
  CHECK(refused("unsigned n = in.x.value(); for (int i = 0; i < 100000; ++i) n = n * 5 + (n >> 3); out.z = u<8>(n);") ==
        "stage.hpp:16: error: loop of 100000 iterations: at most 4096 are unrolled (--max-loop)");
}

TEST_CASE("division", "[diagnostics]") {
  CHECK(refused("out.z = u<8>(in.x.value() / in.y.value());") ==
        "stage.hpp:16: error: division by a variable has no hardware: use a table of reciprocals");
  CHECK(refused("out.z = u<8>(in.x.value() % in.y.value());") ==
        "stage.hpp:16: error: remainder of a division by a variable has no hardware: use a table of reciprocals");
  CHECK(refused("out.z = u<8>(in.x.value() / 10);") ==
        "stage.hpp:16: error: division by a constant that is no power of two: multiply by a reciprocal and shift");
}

TEST_CASE("floating point", "[diagnostics]") {
  CHECK(refused("out.z = u<8>(static_cast<int>(in.x.value() * 0.3f));") ==
        "stage.hpp:16: error: floating point has no hardware: use fixed point");
  CHECK(refused("out.z = in.x;", "double gain_ = 1;") ==
        "stage.hpp:11: error: member `gain` of the stage is floating point (double): use fixed point");
}

TEST_CASE("static and global variables", "[diagnostics]") {
  CHECK(refused("static int calls = 0; out.z = u<8>(++calls);") ==
        "stage.hpp:16: error: `Stage::step(Stage::In const&)::calls` is a static or global variable: state belongs "
        "into members of the "
        "stage, tables must be constexpr");
  CHECK(refused("static const int first = outside(3); out.z = u<8>(first);")
            .find("stage.hpp:16: error: static local variable") == 0);
}

TEST_CASE("virtual functions and function pointers", "[diagnostics]") {
  CHECK(refused("out.z = in.x;", "virtual int f() { return 1; }") ==
        "stage.hpp:7: error: class Stage has virtual functions: calls must be known at compile time");
  CHECK(refused("out.z = u<8>((in.flag ? &Stage::one : &Stage::two)(in.x.value()));",
                "static int one(int x) { return x + 1; } static int two(int x) { return x * 3; }")
            .find("stage.hpp:16: error: call through a function pointer") == 0);
}

TEST_CASE("recursion", "[diagnostics]") {
  CHECK(refused("out.z = u<8>(depth(in.x.value()));",
                "int depth(int n) { return n < 3 ? n : depth(n / 2) + depth(n - 3); }")
            .find(" error: recursive call of Stage::depth(int)") != std::string::npos);
}

TEST_CASE("functions without source, heap, exceptions, abort", "[diagnostics]") {
  CHECK(refused("out.z = u<8>(outside(1));") ==
        "stage.hpp:16: error: call of outside(int), whose source hlsc does not see");
  CHECK(refused("int* p = new int[in.x.value()]; p[0] = 1; out.z = u<8>(p[in.y.value() & 1]); delete[] p;")
            .find("stage.hpp:16: error: heap allocation") == 0);
  CHECK(refused("if (in.flag) throw 3; out.z = in.x;").find("stage.hpp:16: error: an exception can be thrown here") ==
        0);
  CHECK(refused("std::array<int, 4> a{}; out.z = u<8>(a.at(in.x.value()));")
            .find("stage.hpp:16: error: an exception can be thrown here") == 0);
  CHECK(refused("if (in.flag) __builtin_trap(); out.z = in.x;") ==
        "stage.hpp:16: error: the program can be stopped here (trap)");
}

TEST_CASE("volatile, atomics, inline assembly", "[diagnostics]") {
  CHECK(refused("volatile int v = in.x.value(); out.z = u<8>(v);") ==
        "stage.hpp:16: error: volatile access has no hardware");
  CHECK(refused("out.z = in.x; asm volatile(\"nop\");") == "stage.hpp:16: error: inline assembly has no hardware");
  CHECK(refused("int a = in.x.value(); __atomic_fetch_add(&a, 1, 5); out.z = u<8>(a);", "") ==
        "stage.hpp:16: error: atomic access has no hardware");
  CHECK(refused("out.z = in.x;", "volatile int v_ = 0;") == "stage.hpp:11: error: member `v` of the stage is volatile");
}

TEST_CASE("values nobody has set", "[diagnostics]") {
  CHECK(refused("if (in.flag) out.z = in.x;", "struct Raw { int r; };") == "");  // u<8> has an initial value of its own
  CHECK(refused("int n; if (in.flag) n = 3; out.z = u<8>(in.x.value() + n);")
            .find("fatal error: variable 'n' is used uninitialized") != std::string::npos);
  CHECK(refused("std::array<int, 4> a; out.z = u<8>(a[in.y.value() & 3]);") ==
        "stage.hpp:10: error: member `z` of Out is not set on some path");
  CHECK(refused("std::array<int, 4> a; if (in.flag) a[0] = 1; out.z = u<8>(a[in.x.value() & 1] + a[2]);").find("set") !=
        std::string::npos);
  CHECK(refused("count_ = count_ + 1; out.z = u<8>(count_);", "int count_;") ==
        "stage.hpp:11: error: member `count` of the stage has no initial value");
  CHECK(refused("out.z = in.x;", "int never_used_;") == "");
}

TEST_CASE("members of Out that are set on some path only", "[diagnostics]") {
  const auto error = [](const std::string& out, const std::string& body, const std::string& more = "") {
    return error_of(stage_options(
        write_header("out.hpp",
                     "#pragma once\n#include <array>\n#include <horopter/hls/int.hpp>\nusing namespace horopter::hls;\n"
                     "class Stage {\n public:\n  struct In { u<8> x; bool flag; };\n  struct Out { " +
                         out + " };\n  Out step(const In& in) {\n" + body + "\n  }\n" + more + "};\n"),
        "Stage"));
  };
  const std::string refusal = "out.hpp:8: error: member `alarm` of Out is not set on some path";
  const std::string small = "bool alarm; u<8> z;", large = small + " std::array<u<16>, 16> values{};";
  for (const std::string& members : {small, large}) {
    CAPTURE(members);
    CHECK(error(members, "Out out; out.z = in.x; if (in.flag) out.alarm = true; return out;") == refusal);
    CHECK(error(members,
                "Out out; out.z = in.x; if (in.x == 3) return Out{}; if (in.flag) out.alarm = true; "
                "return out;") == refusal);
    CHECK(error(members, "Out out; set(in, out); return out;",
                "void set(const In& in, Out& out) { if (in.flag) out.alarm = in.x > 3; }\n") == refusal);
    CHECK(error(members, "Out out; out.z = in.x; out.alarm = in.flag; return out;") == "");
    CHECK(error(members, "Out out; if (in.flag) out.alarm = in.x > 3; else out.alarm = in.x < 2; return out;") == "");
    CHECK(error(members, "Out out; if (in.flag) out.alarm = in.x > 3; if (!in.flag) out.alarm = true; return out;") ==
          "");
    CHECK(error(members, "return {in.flag, in.x};") == "");
    CHECK(error(members, "Out out{}; if (in.flag) out.alarm = true; return out;") == "");
    CHECK(error(members, "Out last = last_; last_.alarm = in.flag; return last;", " Out last_{};\n") == "");
  }
  CHECK(error("bool alarm = false; u<8> z;", "Out out; if (in.flag) out.alarm = true; return out;") == "");
}

TEST_CASE("the two ports of a memory", "[diagnostics]") {
  CHECK(
      refused(
          "memory_.write(in.x.value() & 15, in.x); memory_.write(in.y.value() & 15, in.y); out.z = memory_.read(1);") ==
      "stage.hpp:16: error: memory `memory` is written at two addresses in one step: it has one write port");
  CHECK(refused("memory_.write(0, in.x); out.z = u<8>(memory_.read(in.x.value() & 15).value() + "
                "memory_.read(in.y.value() & 15).value());") ==
        "stage.hpp:16: error: memory `memory` is read at two addresses in one step: it has one read port");
  CHECK(refused("if (in.flag) memory_.write(1, in.x); else memory_.write(2, in.y); out.z = memory_.read(3);") == "");
  CHECK(
      refused("if (in.flag) memory_.write(1, in.x); if (!in.flag) memory_.write(2, in.y); out.z = memory_.read(3);") ==
      "");
  CHECK(refused(
            "if (in.flag) memory_.write(1, in.x); if (in.x.bit(0)) memory_.write(2, in.y); out.z = memory_.read(3);") ==
        "stage.hpp:16: error: memory `memory` is written at two addresses in one step: it has one write port");
  CHECK(refused("out.z = memory_.read(3); memory_.write(memory_.read(3).value() & 15, in.x);") == "");
}

TEST_CASE("what a memory may not be", "[diagnostics]") {
  CHECK(refused("out.z = more_[in.x.value() & 1].read(2);", "std::array<RAM<u<8>, 16, 4>, 2> more_;") ==
        "stage.hpp:16: error: the memory is chosen by a variable: each access must name one RAM");
  CHECK(refused("RAM<u<8>, 16, 4> local; local.write(in.x.value() & 15, in.y); out.z = local.read(0);") ==
        "stage.hpp:16: error: a RAM must be a member of the stage");
  CHECK(refused("out.z = odd_.read(0).a;", "struct Odd { u<8> a = 3; }; RAM<Odd, 16, 4> odd_;") ==
        "stage.hpp:11: error: the words of memory `odd` are not zero when made without arguments: a RAM is zero at "
        "power-up");
  CHECK(refused("out.z = a_.read(b_.read(0).value() & 15); b_.write(a_.read(1).value() & 15, in.x); ",
                "RAM<u<8>, 16, 4> a_, b_;") ==
        "stage.hpp:16: error: memory `a` is read at two addresses in one step: it has one read port");
}

TEST_CASE("memories that are assigned, copied or swapped", "[diagnostics]") {
  const std::string members = "RAM<u<8>, 16, 4> a_, b_; std::array<RAM<u<8>, 16, 4>, 2> more_;";
  const std::string rest = " a_.write(in.x.value() & 15, in.x); out.z = b_.read(in.y.value() & 15);";
  CHECK(refused(rest, members) == "");
  CHECK(refused("if (in.flag) a_ = b_;" + rest, members)
            .find("stage.hpp:16:17: fatal error: overload resolution selected deleted operator '=': a RAM cannot be "
                  "assigned") != std::string::npos);
  CHECK(refused("RAM<u<8>, 16, 4> copy = a_; out.z = copy.read(0);", members).find("a RAM cannot be copied") !=
        std::string::npos);
  CHECK(refused("a_ = std::move(b_);" + rest, members).find("a RAM cannot be assigned") != std::string::npos);
  CHECK(refused("if (in.flag) std::swap(a_, b_);" + rest, members)
            .find("stage.hpp:16:14: fatal error: no matching function for call to 'swap'") != std::string::npos);
  CHECK(refused("more_[0] = more_[1];" + rest, members).find("a RAM cannot be assigned") != std::string::npos);
  CHECK(refused("if (in.flag) *this = Stage{};" + rest, members).find("stage.hpp:16:") != std::string::npos);
}

TEST_CASE("registers that reset leaves alone begin with zero", "[diagnostics]") {
  CHECK(refused("out.z = k_->v; k_->v = u<8>(k_->v + in.x);", "struct Seven { u<8> v = 7; }; Kept<Seven> k_;") ==
        "stage.hpp:11: error: member `k_v` is Kept and not zero when made without arguments: it is zero at power-up");
  CHECK(refused("out.z = k_->v; k_->v = u<8>(k_->v + in.x);", "struct Zero { u<8> v = 0; }; Kept<Zero> k_;") == "");
}

TEST_CASE("large arrays", "[diagnostics]") {
  CHECK(refused("out.z = big_[in.x.value() * 8 + (in.y.value() & 7)]; big_[in.y.value()] = in.x;",
                "std::array<u<8>, 2048> big_{};")
            .find("stage.hpp:16: error: array of 16384 bits in `the stage` is indexed by a variable") == 0);
  CHECK(refused("out.z = big_[0]; big_[0] = in.x;", "std::array<u<8>, 10000> big_{};")
            .find("stage.hpp:11: error: the stage has 80000 bits of registers, at most 65536 are allowed") == 0);
}

TEST_CASE("types without hardware", "[diagnostics]") {
  CHECK(refused("out.z = in.x;", "union { int a_; char b_; };").find("is a union") != std::string::npos);
  CHECK(refused("out.z = in.x; p_ = in.flag ? &a_ : &b_;", "int a_ = 0, b_ = 0; int* p_ = &a_;") ==
        "stage.hpp:11: error: pointer `p` of the stage changes: pointers must be known at compile time");
  CHECK(refused("out.z = u<8>(*p_); *p_ = in.x.value();", "int a_ = 0; int* p_ = &a_;") == "");
}

TEST_CASE("what is no stage", "[diagnostics]") {
  CHECK(error_of(stage_options(write_header("none.hpp", "struct None {};\n"), "None"))
            .find("a stage has nested types In and Out") != std::string::npos);
  CHECK(refused("out.z = in.nothing;").find("stage.hpp:16:") != std::string::npos);  // clang's own words
}
