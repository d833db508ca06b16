// What stands on the worksheet of a lesson: each page set up afresh, its picture taken, its question answered from its run.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "app/files/worksheet.h"
#include "app/session/session.h"

namespace app {

// Its width by its height.
inline constexpr double sheet_picture_aspect = 4.0 / 3.0;

// PNG of a session, or nothing.
using TakePicture = std::function<std::vector<std::uint8_t>(Session& session)>;

// Of the lesson that is open, which there must be; the session stays as it is.
Worksheet worksheet_of(const Session& session, const TakePicture& take_picture);

}  // namespace app
