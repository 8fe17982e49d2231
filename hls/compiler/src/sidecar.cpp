// SPDX-License-Identifier: Apache-2.0
#include "hlsc/sidecar.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace hlsc {

namespace {

double rounded(double ns) { return std::round(ns * 100.0) / 100.0; }

std::string relative(const std::string& file, const EmitOptions& options) {
  if (options.source_root.empty() || !file.starts_with(options.source_root)) return file;
  const auto start = file.find_first_not_of('/', options.source_root.size());
  return start == std::string::npos ? file : file.substr(start);
}

}  // namespace

std::string sidecar(const Graph& graph, const Schedule& schedule, const EmitOptions& options,
                    const EmittedModule& module) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["top_name"] = graph.top_name;
  json["class"] = options.source_class;
  json["source"] = relative(graph.source_file, options);
  json["target"] = target_name(schedule.options.delays.target);
  json["clock_ns"] = schedule.options.clock_ns;
  json["latency"] = schedule.latency;
  json["registered_outputs"] = registered_outputs(schedule.options);
  json["register_bits"] = {{"state", module.state_bits}, {"pipeline", module.pipeline_bits}};
  unsigned long memory_bits = 0;
  json["memories"] = Json::array();
  for (const auto& m : module.memories) {
    memory_bits += static_cast<unsigned long>(m.depth) * m.width;
    Json entry = {{"name", m.name}, {"kind", m.distance == 0 ? "rom" : "ram"}, {"depth", m.depth}, {"width", m.width}};
    if (m.distance != 0) entry["distance"] = m.distance;
    entry["read_stage"] = m.read_stage;
    if (m.write_stage >= 0) entry["write_stage"] = m.write_stage;
    json["memories"].push_back(entry);
  }
  json["memory_bits"] = memory_bits;
  json["stages"] = Json::array();
  for (int stage = 0; stage < static_cast<int>(schedule.stage_delay_ns.size()); ++stage) {
    Json entry;
    entry["stage"] = stage;
    entry["delay_ns"] = rounded(schedule.stage_delay_ns[static_cast<std::size_t>(stage)]);
    entry["states"] = Json::array();
    for (const State& state : graph.states) {
      if (schedule.stage[state.read] != stage) continue;
      entry["states"].push_back({{"name", state.name}, {"width", state.width}});
      if (state.kept) entry["states"].back()["kept"] = true;
    }
    // Nodes of one source line together, in the order of their first node.
    std::vector<std::string> order;
    std::map<std::string, std::pair<unsigned, std::vector<std::string>>> groups;
    for (NodeId n = 1; n < graph.nodes.size(); ++n) {
      const Node& node = graph.nodes[n];
      if (schedule.stage[n] != stage || node.op == Op::kInput || node.op == Op::kStateRead) continue;
      const std::string where = relative(node.where.file, options) + ":" + std::to_string(node.where.line);
      auto [it, is_new] = groups.try_emplace(where);
      if (is_new) order.push_back(where);
      ++it->second.first;
      auto& names = it->second.second;
      const std::string name = node.op == Op::kRamRead ? graph.rams[node.port].name : node.name;
      if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    entry["operations"] = Json::array();
    for (const auto& where : order) {
      entry["operations"].push_back(
          {{"where", where}, {"count", groups[where].first}, {"names", groups[where].second}});
    }
    json["stages"].push_back(entry);
  }
  json["ports"] = Json::array();
  const auto port = [&](const std::string& name, const char* direction, std::uint32_t width, bool is_signed) {
    json["ports"].push_back({{"name", name}, {"direction", direction}, {"width", width}, {"signed", is_signed}});
  };
  for (const char* name : {"clk_i", "rst_ni", "en_i", "valid_i"}) port(name, "input", 1, false);
  for (std::size_t i = 0; i < graph.inputs.size(); ++i) {
    port(module.input_names[i], "input", graph.inputs[i].width, graph.inputs[i].is_signed);
  }
  for (std::size_t i = 0; i < graph.configs.size(); ++i) {
    port(module.config_names[i], "input", graph.configs[i].width, graph.configs[i].is_signed);
  }
  if (module.parity_error) port("parity_error_o", "output", 1, false);
  port("valid_o", "output", 1, false);
  for (std::size_t i = 0; i < graph.outputs.size(); ++i) {
    port(module.output_names[i], "output", graph.outputs[i].width, graph.outputs[i].is_signed);
  }
  json["warnings"] = schedule.warnings;
  return json.dump(2) + "\n";
}

}  // namespace hlsc
