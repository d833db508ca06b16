#include "app/actions/apply_parts.h"
#include "app/actions/hosting.h"
#include "app/actions/opening.h"
#include "app/actions/show_session.h"
#include "app/files/link.h"
#include "app/files/preferences_file.h"
#include "app/files/rescue.h"
#include "app/files/session_file.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/row_table.h"

namespace app {

// Among the recent ones the session stands for itself, not its mesh.
void take(Session& session, const OpenSession& action) {
  cancel_opening(session);
  if (session.jobs->beside && is_long_to_open(action.path, true))
    return begin_opening_session(session, action.path);
  const auto start = std::chrono::steady_clock::now();
  auto read = read_session(session.program->assets, action.path);
  if (auto* error = std::get_if<std::string>(&read)) {
    notify(session, Notice::Kind::error, std::move(*error));
    note_not_opened(session, {{}, action.path});
    return;
  }
  take_opened(session, std::get<OpenedSession>(std::move(read)), start, false);
}

void take(Session& session, const CopyLink& /*action*/) {
  if (!session.document) return;
  auto link = link_by_session(session);
  const bool by_options = !link;
  if (by_options) link = link_by_options(session);
  if (!link) {
    notify(session, Notice::Kind::warning,
           "Options alone cannot say all of this; save the session first, then the link names "
           "its file.");
    return;
  }
  session.outbox->clipboard = *link;
  tell(session,
       "Copied: " + *link +
           (by_options ? "  (without the camera and the layers; a saved session has them too)" : ""));
}

void take(Session& session, const CopyRows& /*action*/) {
  if (!session.document) return;
  session.outbox->clipboard = rows_csv(session);
  tell(session, "Copied the list of rows as CSV.");
}

// It stays on offer until it could be opened, and on disk until this program has a file of its own: the same one.
void take(Session& session, const TakeRescued& /*action*/) {
  if (!session.program->rescued) return;
  cancel_opening(session);
  if (session.jobs->beside && is_long_to_open(session.program->rescued->path, true))
    return begin_opening_rescued(session);
  const auto start = std::chrono::steady_clock::now();
  auto read = read_session(session.program->assets, session.program->rescued->path);
  if (auto* error = std::get_if<std::string>(&read)) {
    notify(session, Notice::Kind::error, std::move(*error));
    return;
  }
  take_opened(session, std::get<OpenedSession>(std::move(read)), start, true);
}

void take_opened(Session& session, OpenedSession opened, std::chrono::steady_clock::time_point start,
                 bool rescued) {
  const std::filesystem::path path = opened.path;
  std::vector<std::string> recent = session.program->preferences.recent;
  show_session(session, std::move(opened), start);
  if (!rescued) {
    session.program->preferences.recent = std::move(recent);
    note_recent(session.program->preferences, recent_name(path));
    return;
  }
  session.program->rescued.reset();
  session.document->saved.reset();  // that file is nobody's to name
  std::error_code ignored;
  std::filesystem::rename(path, rescue_file(path.parent_path(), this_process()), ignored);
}

void take(Session& session, const DropRescued& /*action*/) {
  if (!session.program->rescued) return;
  std::error_code ignored;
  std::filesystem::remove(session.program->rescued->path, ignored);
  session.program->rescued = find_rescued(session.program->rescued->path.parent_path());
}

}  // namespace app
