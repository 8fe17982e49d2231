// SPDX-License-Identifier: Apache-2.0
#include "emit_check.hpp"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace hlsc::test {

Builder::Builder(std::string name) {
  graph.top_name = std::move(name);
  graph.source_file = "test.hpp";
  Node constant;
  constant.width = 2;
  graph.nodes.push_back(constant);
}

NodeId Builder::node(Node n) {
  n.where = {"test.hpp", line};
  graph.nodes.push_back(std::move(n));
  return static_cast<NodeId>(graph.nodes.size() - 1);
}

namespace {

Bits all_bits(NodeId n, std::uint32_t width) {
  Bits bits;
  for (std::uint32_t i = 0; i < width; ++i) bits.push_back({n, i});
  return bits;
}

std::uint64_t mask(std::uint32_t width) { return width >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1; }

std::int64_t as_signed(std::uint64_t value, std::uint32_t width) {
  const auto shift = 64 - width;
  return static_cast<std::int64_t>(value << shift) >> shift;
}

}  // namespace

Bits Builder::input(const std::string& name, std::uint32_t width, bool is_signed) {
  const auto port = static_cast<std::uint32_t>(graph.inputs.size());
  const NodeId n = node({Op::kInput, width, {}, port, name, {}});
  graph.inputs.push_back({name, width, is_signed, n, {}});
  return all_bits(n, width);
}

Bits Builder::config(const std::string& name, std::uint32_t width) {
  const auto port = static_cast<std::uint32_t>(graph.configs.size());
  const NodeId n = node({Op::kConfig, width, {}, port, name, {}});
  graph.configs.push_back({name, width, false, n, {}});
  return all_bits(n, width);
}

Bits Builder::state(const std::string& name, std::uint32_t width, std::uint64_t initial) {
  const auto port = static_cast<std::uint32_t>(graph.states.size());
  const NodeId n = node({Op::kStateRead, width, {}, port, name, {}});
  State s{name, width, {}, n, all_bits(n, width)};
  for (std::uint32_t i = 0; i < width; ++i) s.initial.push_back(((initial >> i) & 1U) != 0);
  graph.states.push_back(s);
  return all_bits(n, width);
}

void Builder::set_next(const Bits& state, const Bits& next) {
  graph.states.at(graph.nodes.at(state.at(0).node).port).next = next;
}

void Builder::output(const std::string& name, const Bits& value, bool is_signed) {
  graph.outputs.push_back({name, static_cast<std::uint32_t>(value.size()), is_signed, 0, value});
}

Bits Builder::op(Op op, std::uint32_t width, std::vector<Bits> operands, const std::string& name) {
  return all_bits(node({op, width, std::move(operands), 0, name, {}}), width);
}

Bits Builder::add(const Bits& a, const Bits& b, const std::string& name) {
  const auto width = static_cast<std::uint32_t>(std::max(a.size(), b.size())) + 1;
  return op(Op::kAdd, width, {zero_extend(a, width), zero_extend(b, width)}, name);
}

Bits Builder::sub(const Bits& a, const Bits& b, const std::string& name) {
  return op(Op::kSub, static_cast<std::uint32_t>(a.size()), {a, b}, name);
}

Bits Builder::mux(const Bits& condition, const Bits& a, const Bits& b) {
  return op(Op::kMux, static_cast<std::uint32_t>(a.size()), {condition, a, b});
}

Bits Builder::rom(const std::string& name, const Bits& address, std::uint32_t width,
                  const std::vector<std::uint64_t>& words) {
  Rom rom{name, width, {}};
  for (auto w : words) {
    rom.words.emplace_back();
    for (std::uint32_t i = 0; i < width; ++i) rom.words.back().push_back(((w >> i) & 1U) != 0);
  }
  graph.roms.push_back(rom);
  return all_bits(node({Op::kRom, width, {address}, static_cast<std::uint32_t>(graph.roms.size() - 1), name, {}}),
                  width);
}

Bits Builder::ram_read(const std::string& name, std::uint32_t depth, std::uint32_t width, std::uint32_t distance,
                       const Bits& address) {
  const auto port = static_cast<std::uint32_t>(graph.rams.size());
  const NodeId n = node({Op::kRamRead, width, {}, port, name, {}});
  Ram ram;
  ram.name = name;
  ram.depth = depth;
  ram.width = width;
  ram.distance = distance;
  ram.read = n;
  ram.read_address = address;
  ram.read_enable = kOne;
  ram.where = {"test.hpp", line};
  graph.rams.push_back(ram);
  return all_bits(n, width);
}

void Builder::ram_write(const std::string& name, const Bits& address, const Bits& data, const Bits& enable) {
  for (Ram& ram : graph.rams) {
    if (ram.name != name) continue;
    ram.write_address = address;
    ram.write_data = data;
    ram.write_enable = enable.at(0);
  }
}

Bits constant(std::uint64_t value, std::uint32_t width) {
  Bits bits;
  for (std::uint32_t i = 0; i < width; ++i) bits.push_back(((value >> i) & 1U) != 0 ? kOne : kZero);
  return bits;
}

Bits zero_extend(Bits bits, std::uint32_t width) {
  bits.resize(width, kZero);
  return bits;
}

Bits sign_extend(Bits bits, std::uint32_t width) {
  bits.resize(width, bits.back());
  return bits;
}

Bits slice(const Bits& bits, std::uint32_t high, std::uint32_t low) {
  return {bits.begin() + low, bits.begin() + high + 1};
}

Bits concat(const std::vector<Bits>& most_significant_first) {
  Bits bits;
  for (auto it = most_significant_first.rbegin(); it != most_significant_first.rend(); ++it) {
    bits.insert(bits.end(), it->begin(), it->end());
  }
  return bits;
}

Interpreter::Interpreter(const Graph& graph) : g_(graph), value_(graph.nodes.size(), 0) {
  for (const Ram& ram : g_.rams) memory_.emplace_back(ram.depth, 0);
  reset();
}

void Interpreter::reset() {
  state_.clear();
  for (const State& s : g_.states) {
    std::uint64_t v = 0;
    for (std::uint32_t i = 0; i < s.width; ++i) v |= std::uint64_t{s.initial[i]} << i;
    state_.push_back(v);
  }
}

std::uint64_t Interpreter::gather(const Bits& bits) const {
  std::uint64_t v = 0;
  for (std::size_t i = 0; i < bits.size(); ++i) v |= std::uint64_t{bit(bits[i])} << i;
  return v;
}

Interpreter::Result Interpreter::step(const std::vector<std::uint64_t>& inputs,
                                      const std::vector<std::uint64_t>& configs) {
  for (NodeId n = 1; n < g_.nodes.size(); ++n) {
    const Node& node = g_.nodes[n];
    const auto w = [&](std::size_t i) { return static_cast<std::uint32_t>(node.operands[i].size()); };
    const auto u = [&](std::size_t i) { return gather(node.operands[i]); };
    const auto s = [&](std::size_t i) { return as_signed(u(i), w(i)); };
    std::uint64_t v = 0;
    switch (node.op) {
      case Op::kConstant:
        break;
      case Op::kInput:
        v = inputs.at(node.port);
        break;
      case Op::kConfig:
        v = configs.at(node.port);
        break;
      case Op::kStateRead:
        v = state_.at(node.port);
        break;
      case Op::kRamRead:
        v = memory_[node.port].at(gather(g_.rams[node.port].read_address));
        break;
      case Op::kRom: {
        const Rom& rom = g_.roms[node.port];
        if (u(0) < rom.words.size()) {
          for (std::uint32_t i = 0; i < node.width; ++i) v |= std::uint64_t{rom.words[u(0)][i]} << i;
        }
        break;
      }
      case Op::kAnd:
        v = u(0) & u(1);
        break;
      case Op::kOr:
        v = u(0) | u(1);
        break;
      case Op::kXor:
        v = u(0) ^ u(1);
        break;
      case Op::kNot:
        v = ~u(0);
        break;
      case Op::kAdd:
        v = u(0) + u(1);
        break;
      case Op::kSub:
        v = u(0) - u(1);
        break;
      case Op::kMul:
        v = u(0) * u(1);
        break;
      case Op::kMulSigned:
        v = static_cast<std::uint64_t>(s(0)) * static_cast<std::uint64_t>(s(1));
        break;
      case Op::kShl:
        v = u(1) >= node.width ? 0 : u(0) << u(1);
        break;
      case Op::kLshr:
        v = u(1) >= node.width ? 0 : u(0) >> u(1);
        break;
      case Op::kAshr:
        v = static_cast<std::uint64_t>(s(0) >> std::min<std::uint64_t>(u(1), 63));
        break;
      case Op::kEq:
        v = u(0) == u(1);
        break;
      case Op::kUlt:
        v = u(0) < u(1);
        break;
      case Op::kSlt:
        v = s(0) < s(1);
        break;
      case Op::kMux:
        v = u(0) != 0 ? u(1) : u(2);
        break;
      case Op::kReduceOr:
        v = u(0) != 0;
        break;
      case Op::kReduceAnd:
        v = u(0) == mask(w(0));
        break;
      case Op::kReduceXor:
        v = static_cast<unsigned>(__builtin_popcountll(u(0))) & 1U;
        break;
    }
    value_[n] = v & mask(node.width);
  }
  Result r;
  for (const Port& out : g_.outputs) r.outputs.push_back(gather(out.value));
  r.valid = bit(g_.output_valid);
  for (std::size_t i = 0; i < g_.states.size(); ++i) state_[i] = gather(g_.states[i].next);
  for (std::size_t i = 0; i < g_.rams.size(); ++i) {
    if (bit(g_.rams[i].write_enable)) {
      memory_[i].at(gather(g_.rams[i].write_address)) = gather(g_.rams[i].write_data);
    }
  }
  return r;
}

std::pair<std::string, bool> run_command(const std::string& command) {
  std::string text;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return {"cannot run " + command, false};
  std::array<char, 4096> buffer{};
  while (const auto n = fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
  return {text, pclose(pipe) == 0};
}

std::string check_module(const Graph& graph, const Schedule& schedule, unsigned steps, unsigned seed,
                         const EmitOptions& options) {
  for (const char* tool : {"verilator", "yosys", "iverilog", "vvp"}) {
    if (!run_command(std::string("command -v ") + tool).second) {
      return std::string(tool) + " is missing: install the Debian packages verilator, yosys and iverilog";
    }
  }
  namespace fs = std::filesystem;
  const fs::path directory = fs::temp_directory_path() /
                             ("hlsc-" + graph.top_name + "-" + std::to_string(getpid()) + "-" + std::to_string(seed));
  fs::create_directories(directory);
  const std::string module = (directory / (graph.top_name + ".sv")).string();
  const EmittedModule emitted = emit(graph, schedule, options);
  std::ofstream(module) << emitted.text;
  const std::string where = "(files in " + directory.string() + ")\n";

  if (const auto [text, ok] = run_command("verilator --lint-only -Wall " + module); !ok || !text.empty()) {
    return "verilator " + where + text;
  }
  if (const auto [text, ok] = run_command("yosys -q -p 'read_verilog -sv " + module + "; hierarchy -check -top " +
                                          graph.top_name + "; proc; memory -nomap; check -assert'");
      !ok || !text.empty()) {
    return "yosys " + where + text;
  }

  // One line of hexadecimal numbers per clock: en, valid, inputs…; one per result.
  std::mt19937_64 random(seed);
  std::vector<std::uint64_t> configs, inputs(graph.inputs.size());
  for (const Port& p : graph.configs) configs.push_back(random() & mask(p.width));
  Interpreter interpreter(graph);
  std::ofstream stimuli(directory / "stimuli.hex"), expected(directory / "expected.hex");
  stimuli << std::hex;
  expected << std::hex;
  unsigned results = 0;
  const unsigned flush = static_cast<unsigned>(schedule.latency) + 4;
  for (unsigned i = 0; i < steps + flush; ++i) {
    const bool enable = i >= steps || random() % 8 != 0;
    const bool valid = i < steps && random() % 4 != 0;
    stimuli << enable << ' ' << valid;
    for (std::size_t p = 0; p < inputs.size(); ++p) {
      inputs[p] = random() & mask(graph.inputs[p].width);
      stimuli << ' ' << inputs[p];
    }
    stimuli << '\n';
    if (!enable || !valid) continue;
    const auto r = interpreter.step(inputs, configs);
    if (!r.valid) continue;
    for (std::size_t p = 0; p < r.outputs.size(); ++p) expected << (p == 0 ? "" : " ") << r.outputs[p];
    expected << '\n';
    ++results;
  }
  stimuli.close();
  expected.close();
  std::ofstream bench(directory / "bench.sv");
  bench << "module bench;\n  reg clk = 0, rst_n = 0, en = 0, valid = 0;\n  always #1 clk = ~clk;\n"
           "  integer in_file, out_file, n, results = 0, errors = 0;\n  wire valid_o, parity_error;\n";
  for (std::size_t i = 0; i < graph.inputs.size(); ++i)
    bench << "  reg [" << graph.inputs[i].width - 1 << ":0] i" << i << ";\n";
  for (std::size_t i = 0; i < graph.outputs.size(); ++i) {
    bench << "  wire [" << graph.outputs[i].width - 1 << ":0] o" << i << ";\n  reg [" << graph.outputs[i].width - 1
          << ":0] e" << i << ";\n";
  }
  bench << "  " << graph.top_name << " dut (.clk_i(clk), .rst_ni(rst_n), .en_i(en), .valid_i(valid), .valid_o(valid_o)";
  for (std::size_t i = 0; i < graph.inputs.size(); ++i) bench << ", ." << graph.inputs[i].name << "_i(i" << i << ")";
  for (std::size_t i = 0; i < graph.configs.size(); ++i) {
    bench << ", .cfg_" << graph.configs[i].name << "_i(" << graph.configs[i].width << "'d" << configs[i] << ")";
  }
  for (std::size_t i = 0; i < graph.outputs.size(); ++i) bench << ", ." << graph.outputs[i].name << "_o(o" << i << ")";
  if (emitted.parity_error) bench << ", .parity_error_o(parity_error)";
  bench << ");\n  initial begin\n    in_file = $fopen(\"" << (directory / "stimuli.hex").string()
        << "\", \"r\");\n    out_file = $fopen(\"" << (directory / "expected.hex").string()
        << "\", \"r\");\n    @(negedge clk); @(negedge clk); rst_n = 1;\n    while (!$feof(in_file)) begin\n";
  std::string formats, arguments;
  for (std::size_t i = 0; i < graph.inputs.size(); ++i) {
    formats += " %h";
    arguments += ", i" + std::to_string(i);
  }
  std::ostringstream line;
  line << "$fscanf(in_file, \"%h %h" << formats << "\\n\", en, valid" << arguments << ")";
  bench << "      n = " << line.str()
        << ";\n      #0;\n      if (en && valid_o) begin\n        n = $fscanf(out_file, \"";
  for (std::size_t i = 0; i < graph.outputs.size(); ++i) bench << (i == 0 ? "%h" : " %h");
  bench << "\\n\"";
  for (std::size_t i = 0; i < graph.outputs.size(); ++i) bench << ", e" << i;
  bench << ");\n        results = results + 1;\n";
  for (std::size_t i = 0; i < graph.outputs.size(); ++i) {
    bench << "        if (o" << i << " !== e" << i
          << ") begin errors = errors + 1; if (errors < 6) $display(\"result %0d, " << graph.outputs[i].name
          << ": %h, expected %h\", results, o" << i << ", e" << i << "); end\n";
  }
  bench << "      end\n      @(negedge clk);\n";
  if (emitted.parity_error)
    bench << "      if (parity_error !== 0) begin errors = errors + 1; $display(\"parity\"); end\n";
  bench << "    end\n";
  for (const EmittedMemory& memory : emitted.memories) {
    if (!emitted.parity_error) break;
    const std::string words = "dut." + memory.name + "_mem[n]";
    bench << "    for (n = 0; n < " << memory.depth << "; n = n + 1) " << words << " = " << words << " ^ 1;\n"
          << "    en = 1; valid = 1; n = 0;\n    repeat (" << 2 * memory.depth + flush
          << ") begin @(negedge clk); if (parity_error) n = n + 1; end\n"
          << "    if (n < " << memory.depth << ") begin errors = errors + 1; $display(\"" << memory.name
          << ": %0d words found\", n); end\n";
  }
  bench << "    if (errors == 0 && results == " << results
        << ") $display(\"same\"); else $display(\"%0d errors, %0d results, expected " << results
        << "\", errors, results);\n    $finish;\n  end\nendmodule\n";
  bench.close();
  const std::string program = (directory / "bench.vvp").string();
  if (const auto [text, ok] = run_command("iverilog -g2012 -Wall -Wno-timescale -o " + program + " " +
                                          (directory / "bench.sv").string() + " " + module);
      !ok) {
    return "iverilog " + where + text;
  }
  const auto [text, ok] = run_command("vvp -n " + program);
  if (!ok || text.find("same") == std::string::npos || text.find("ERROR") != std::string::npos) {
    return "simulation " + where + text;
  }
  fs::remove_all(directory);
  return "";
}

}  // namespace hlsc::test
