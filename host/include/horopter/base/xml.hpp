// SPDX-License-Identifier: Apache-2.0
// Text in files of XML, SVG and HTML.
#pragma once

#include <string>
#include <string_view>

namespace horopter {

/// Words as they stand between tags, or in quotes within one.
std::string xml_text(std::string_view words);

}  // namespace horopter
