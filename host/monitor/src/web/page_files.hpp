// SPDX-License-Identifier: Apache-2.0
// The files of the page, as they are beside this one.
#pragma once

#include <string_view>

namespace horopter::monitor::page {

extern const std::string_view kHtml;
extern const std::string_view kCss;
extern const std::string_view kJs;
extern const std::string_view kIcon;

}  // namespace horopter::monitor::page
