#pragma once

#include <string_view>

namespace gyromode {

/// page.html as it stands beside this file when the library is built: the bundle of web/, with a place for documents.
std::string_view embedded_page();

}  // namespace gyromode
