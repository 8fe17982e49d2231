// SPDX-License-Identifier: Apache-2.0
// horopter study all: every study, one page without network, and what of the thesis holds.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "horopter/base/file.hpp"
#include "horopter/base/xml.hpp"
#include "horopter/image/output.hpp"
#include "statements.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

namespace fs = std::filesystem;

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) result += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return result;
}

std::string text_of(const fs::path& path) {
  const std::vector<std::uint8_t> bytes = read_file(path, "a file that this run has written");
  return {bytes.begin(), bytes.end()};
}

/// Plots go into the page as they are, pictures as data.
std::string figure(const fs::path& file, const std::string& title) {
  std::string content;
  if (file.extension() == ".svg") {
    content = text_of(file);
    const std::size_t start = content.find("<svg");
    if (start != std::string::npos) content.erase(0, start);
  } else {
    content = fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", xml_text(title),
                          base64(read_file(file, "a picture that this run has written")));
  }
  return fmt::format("<figure>\n{}\n<figcaption>{}</figcaption>\n</figure>\n", content, xml_text(title));
}

std::string statements_table(const nlohmann::json& statements) {
  std::string table =
      "<table><tr><th>§</th><th>The thesis says</th><th>We found</th><th>Verdict</th><th>Rule</th></tr>\n";
  for (const auto& row : statements) {
    const auto text = [&](const char* key) { return xml_text(row.at(key).get<std::string>()); };
    table += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td><b>{}</b></td><td>{}</td></tr>\n", text("section"),
                         text("statement"), text("figure"), text("verdict"), text("rule"));
  }
  return table + "</table>\n";
}

/// [{"file", "title"}] of a study's result; without that, all its plots.
nlohmann::json figures_of(const fs::path& directory, const nlohmann::json& result) {
  if (result.contains("figures")) return result["figures"];
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.path().extension() == ".svg") names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  nlohmann::json list = nlohmann::json::array();
  for (const std::string& name : names) list.push_back({{"file", name}, {"title", name}});
  return list;
}

std::string section(const fs::path& directory, const NamedStudy& study, const nlohmann::json& result) {
  std::string html = fmt::format("<h2 id=\"{0}\">{0}</h2>\n<p>{1}</p>\n", study.name, xml_text(study.what));
  if (result.contains("conditions")) {
    html += fmt::format("<h3>Conditions</h3>\n<pre>{}</pre>\n", xml_text(result["conditions"].dump(2)));
  }
  html += "<h3>Findings</h3>\n<ul>\n";
  for (const auto& line : result.at("findings"))
    html += fmt::format("<li>{}</li>\n", xml_text(line.get<std::string>()));
  html += "</ul>\n";
  if (result.contains("statements")) html += statements_table(result["statements"]);
  for (const auto& one : figures_of(directory, result))
    html += figure(directory / one.at("file").get<std::string>(), one.at("title").get<std::string>());
  html += "<p>Tables:";
  std::vector<std::string> tables;
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.path().extension() == ".csv") tables.push_back(entry.path().filename().string());
  std::sort(tables.begin(), tables.end());
  for (const std::string& name : tables) html += fmt::format(" <a href=\"{0}/{1}\">{1}</a>", study.name, name);
  return html + "</p>\n";
}

}  // namespace

nlohmann::json study_all(const std::string& out, const StudyScope& scope) {
  nlohmann::ordered_json results;
  std::string contents;
  std::string sections;
  nlohmann::json summary{{"findings", nlohmann::json::array()}, {"seed", scope.seed}, {"quick", scope.quick}};
  for (const NamedStudy& study : studies()) {
    const fs::path place = fs::path(out) / study.name;
    nlohmann::json result;
    {
      OutputDirectory directory(place);
      result = study.run(directory, scope);
      result["seed"] = scope.seed;
      result["quick"] = scope.quick;
      directory.write("summary.json", result.dump(2) + "\n");
      directory.commit();
    }
    contents += fmt::format("<li><a href=\"#{0}\">{0}</a>: {1}</li>\n", study.name, xml_text(study.what));
    sections += section(place, study, result);
    results[study.name] = result;
  }
  int statements = 0;
  int confirmed = 0;
  int partly = 0;
  for (const auto& [name, result] : results.items()) {
    summary["studies"].push_back(name);
    if (!result.contains("statements")) continue;
    for (const auto& row : result["statements"]) {
      ++statements;
      confirmed += row.at("verdict") == "confirmed" ? 1 : 0;
      partly += row.at("verdict") == "partly" ? 1 : 0;
    }
  }
  summary["statements"] = {{"all", statements},
                           {"confirmed", confirmed},
                           {"partly", partly},
                           {"not_confirmed", statements - confirmed - partly}};
  summary["findings"].push_back(fmt::format("{} statements: {} confirmed, {} partly, {} not confirmed", statements,
                                            confirmed, partly, statements - confirmed - partly));
  summary["findings"].push_back(fmt::format("The page is {}, the statements are in {}",
                                            (fs::path(out) / "index.html").string(),
                                            (fs::path(out) / "STUDY.md").string()));
  const std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Horopter: the study</title>\n<style>"
      "body{{font-family:Helvetica,Arial,sans-serif;max-width:1000px;margin:2em auto;padding:0 1em}}"
      "svg,img{{max-width:100%;height:auto}}table{{border-collapse:collapse;font-size:85%}}"
      "td,th{{border:1px solid #ccc;padding:3px 6px;text-align:left;vertical-align:top}}figure{{margin:2em 0}}"
      "pre{{background:#f4f4f4;padding:.5em;overflow:auto}}figcaption{{font-weight:bold}}</style></head>\n<body>\n"
      "<h1>Horopter: the study</h1>\n<p>Written by <code>horopter study all --seed {}{}</code>. "
      "{}</p>\n<ul>\n{}</ul>\n{}"
      "</body></html>\n",
      scope.seed, scope.quick ? " --quick" : "", xml_text(summary["findings"][0].get<std::string>()), contents,
      sections);
  write_file(fs::path(out) / "index.html", page);
  write_file(fs::path(out) / "STUDY.md", study_markdown(results));
  write_file(fs::path(out) / "summary.json", summary.dump(2) + "\n");
  return summary;
}

}  // namespace horopter::cli
