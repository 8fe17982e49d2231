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
#include "page.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

namespace fs = std::filesystem;

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) result += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
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

/// Names of a directory's tables, sorted.
std::vector<std::string> tables_in(const fs::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.path().extension() == ".csv") names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
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
  for (const auto& one : result.at("figures"))
    html += figure(directory / one.at("file").get<std::string>(), one.at("title").get<std::string>());
  html += "<p>Tables:";
  for (const std::string& name : tables_in(directory))
    html += fmt::format(" <a href=\"{0}/{1}\">{1}</a>", study.name, name);
  return html + "</p>\n";
}

std::string page(const StudyScope& scope, const std::string& verdicts, const std::string& contents,
                 const std::string& sections) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Horopter: the study</title>\n<style>"
      "body{{font-family:Helvetica,Arial,sans-serif;max-width:1000px;margin:2em auto;padding:0 1em}}"
      "svg,img{{max-width:100%;height:auto}}table{{border-collapse:collapse;font-size:85%}}"
      "td,th{{border:1px solid #ccc;padding:3px 6px;text-align:left;vertical-align:top}}figure{{margin:2em 0}}"
      "pre{{background:#f4f4f4;padding:.5em;overflow:auto}}figcaption{{font-weight:bold}}</style></head>\n<body>\n"
      "<h1>Horopter: the study</h1>\n<p>Written by <code>horopter study all --seed {}{}</code>. "
      "{}</p>\n<ul>\n{}</ul>\n{}"
      "</body></html>\n",
      scope.seed, scope.quick ? " --quick" : "", xml_text(verdicts), contents, sections);
}

/// {"all", "confirmed", "partly", "not_confirmed"}: counts of statements.
nlohmann::json count_verdicts(const std::vector<StatementGroup>& groups) {
  StatementGroup total;
  for (const StatementGroup& group : groups) {
    total.confirmed += group.confirmed;
    total.partly += group.partly;
    total.not_confirmed += group.not_confirmed;
  }
  return {{"all", total.all()},
          {"confirmed", total.confirmed},
          {"partly", total.partly},
          {"not_confirmed", total.not_confirmed}};
}

}  // namespace

nlohmann::json study_all(const std::string& out, const StudyScope& scope) {
  const fs::path place(out);
  OutputDirectory directory(place);
  directory.set_aside("summary.json");
  nlohmann::ordered_json results;
  std::string contents;
  std::string sections;
  nlohmann::json summary{{"seed", scope.seed}, {"quick", scope.quick}};
  for (const NamedStudy& study : studies()) {
    const nlohmann::json result = run_study(study.run, place / study.name, scope);
    contents += fmt::format("<li><a href=\"#{0}\">{0}</a>: {1}</li>\n", study.name, xml_text(study.what));
    sections += section(place / study.name, study, result);
    results[study.name] = result;
    summary["studies"].push_back(study.name);
  }
  const nlohmann::json counts = count_verdicts(statement_groups(results));
  const std::string verdicts =
      fmt::format("{} statements: {} confirmed, {} partly, {} not confirmed", counts["all"].get<int>(),
                  counts["confirmed"].get<int>(), counts["partly"].get<int>(), counts["not_confirmed"].get<int>());
  summary["statements"] = counts;
  summary["findings"] = {verdicts, "In the directory of --out: the page is index.html, the statements are in STUDY.md"};
  directory.write("index.html", page(scope, verdicts, contents, sections));
  directory.write("STUDY.md", study_markdown(results));
  directory.write("summary.json", summary.dump(2) + "\n");
  directory.commit();
  return summary;
}

}  // namespace horopter::cli
