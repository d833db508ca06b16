#include <algorithm>
#include <cmath>

#include "app/actions/apply_parts.h"
#include "app/files/preferences_file.h"
#include "app/session/document.h"
#include "app/session/preferences.h"
#include "app/session/program.h"

namespace app {

void take(Session& session, const SetTheme& action) { session.program->preferences.theme = action.theme; }

void take(Session& session, const SetScale& action) {
  if (std::isfinite(action.scale))
    session.program->preferences.scale = std::clamp(action.scale, smallest_scale, largest_scale);
}

void take(Session& session, const SetMotion& action) { session.program->preferences.motion = action.on; }

void take(Session& session, const ShowPanel& action) {
  if (action.panel == every_panel) return session.program->preferences.panels.fill(action.open);
  session.program->preferences.panels[static_cast<std::size_t>(action.panel)] = action.open;
}

void take(Session& session, const ShowRowColumn& action) {
  session.program->preferences.row_columns[static_cast<std::size_t>(action.column)] = action.shown;
}

void take(Session& session, const SetSplit& action) {
  if (std::isfinite(action.size) && action.size >= 0.0)
    session.program->preferences.splits[static_cast<std::size_t>(action.split)] = action.size;
}

void take(Session& session, const ResetLayout& /*action*/) {
  session.program->preferences.panels = Preferences{}.panels;
  session.program->preferences.splits = {};
}

void take(Session& session, const ForgetRecent& /*action*/) { session.program->preferences.recent.clear(); }

void note_opened(Session& session) {
  const Source& source = session.document->source;
  if (source.file.empty() && source.example.empty()) return;
  note_recent(session.program->preferences,
              source.file.empty() ? std::string(example_prefix) + source.example : recent_name(source.file));
}

void note_not_opened(Session& session, const Source& source) {
  std::error_code unknown;
  if (source.file.empty() || std::filesystem::exists(source.file, unknown) || unknown) return;
  std::erase(session.program->preferences.recent, recent_name(source.file));
}

}  // namespace app
