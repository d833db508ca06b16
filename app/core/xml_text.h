// Text inside XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace app {

// For between tags and in attributes in double quotes. What XML cannot hold (control characters) is left out.
std::string xml_text(std::string_view text);

}  // namespace app
