#include "app/core/apply_parts.h"
#include "app/core/link.h"
#include "app/core/recent.h"
#include "app/core/rescue.h"
#include "app/core/session_file.h"

namespace app {

// Among the recent ones the session stands for itself, not its mesh.
void take(Session& session, const OpenSession& action) {
  const std::vector<std::string> recent = session.preferences.recent;
  if (auto error = open_session(session, action.path)) {
    session.notices.push_back({Notice::Kind::error, std::move(*error)});
    note_not_opened(session, {{}, action.path});
    return;
  }
  session.preferences.recent = recent;
  note_recent(session.preferences, recent_name(action.path));
}

void take(Session& session, const CopyLink& /*action*/) {
  if (!session.timeline) return;
  auto link = link_by_session(session);
  const bool by_options = !link;
  if (by_options) link = link_by_options(session);
  if (!link) {
    session.notices.push_back(
        {Notice::Kind::warning,
         "Options alone cannot say all of this; save the session first, then the link names "
         "its file."});
    return;
  }
  session.clipboard_wanted = *link;
  tell(session,
       "Copied: " + *link +
           (by_options ? "  (without the camera and the layers; a saved session has them too)" : ""));
}

// It stays on offer until it could be opened, and on disk until this program has a file of its own: the same one.
void take(Session& session, const TakeRescued& /*action*/) {
  if (!session.rescued) return;
  const Rescued rescued = *session.rescued;
  if (auto error = open_session(session, rescued.path)) {
    session.notices.push_back({Notice::Kind::error, std::move(*error)});
    return;
  }
  session.rescued.reset();
  session.saved.reset();  // that file is nobody's to name
  std::error_code ignored;
  std::filesystem::rename(rescued.path, rescue_file(rescued.path.parent_path(), this_process()), ignored);
}

void take(Session& session, const DropRescued& /*action*/) {
  if (!session.rescued) return;
  std::error_code ignored;
  std::filesystem::remove(session.rescued->path, ignored);
  session.rescued = find_rescued(session.rescued->path.parent_path());
}

}  // namespace app
