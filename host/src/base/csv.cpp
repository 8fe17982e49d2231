// SPDX-License-Identifier: Apache-2.0
#include "horopter/base/csv.hpp"

#include <fmt/format.h>

namespace horopter {

Csv::Csv(const std::vector<std::string>& header) { text_ = fmt::format("{}\n", fmt::join(header, ",")); }
Csv& Csv::operator<<(const std::string& field) {
  if (!first_) text_ += ',';
  first_ = false;
  if (field.find_first_of(",\"\n") == std::string::npos) {
    text_ += field;
    return *this;
  }
  text_ += '"';
  for (const char c : field) text_ += c == '"' ? "\"\"" : std::string(1, c);
  text_ += '"';
  return *this;
}
Csv& Csv::operator<<(double field) { return *this << fmt::format("{:.6g}", field); }
void Csv::end_row() {
  text_ += '\n';
  first_ = true;
}

}  // namespace horopter
