// SPDX-License-Identifier: Apache-2.0
// Tables as text that other programs read.
#pragma once

#include <string>
#include <vector>

namespace horopter {

/// Rows of a table; numbers are written so that they read back the same to 6 digits. A field with a comma, a quote or a new
/// line stands in quotes (RFC 4180).
class Csv {
 public:
  /// Names of the columns; one string may have several, with commas between them.
  explicit Csv(const std::vector<std::string>& header);
  Csv& operator<<(const std::string& field);
  Csv& operator<<(double field);
  void end_row();
  /// All fields of a row, or its last ones.
  template <class... Fields>
  void row(const Fields&... fields) {
    (*this << ... << fields);
    end_row();
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  bool first_ = true;
};

}  // namespace horopter
