#include "app/actions/hosting.h"

#include <algorithm>
#include <utility>

#include "app/actions/background_work.h"
#include "app/files/figures.h"
#include "app/session/action.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"

namespace app {

Session new_session(std::filesystem::path assets) {
  Session session;
  session.program->assets = std::move(assets);
  return session;
}

bool set_beside(Session& session, bool beside) { return std::exchange(session.jobs->beside, beside); }

void embed(Session& session) { session.program->embedded = true; }

void offer_rescued(Session& session, std::optional<Rescued> rescued) {
  session.program->rescued = std::move(rescued);
}

void notify(Session& session, Notice::Kind kind, std::string words) {
  Notice notice{kind, std::move(words)};
  auto& notices = session.outbox->notices;
  const auto same = std::find_if(notices.begin(), notices.end(), [&](const Notice& before) {
    return before.kind == notice.kind && before.text == notice.text;
  });
  if (same != notices.end()) {
    notice.times = static_cast<std::uint16_t>(std::min(same->times + 1, 9999));
    notices.erase(same);
  }
  notices.push_back(std::move(notice));
}

void notify_saved(Session& session, const std::filesystem::path& path,
                  const std::optional<std::string>& error) {
  if (error) return notify(session, Notice::Kind::error, *error);
  notify(session, Notice::Kind::info, "Saved " + path.string() + ".");
}

Outbox take_outgoing(Session& session) {
  Outbox& outbox = *session.outbox;
  Outbox taken;
  std::swap(taken.pictures, outbox.pictures);
  std::swap(taken.pages, outbox.pages);
  std::swap(taken.worksheets, outbox.worksheets);
  std::swap(taken.screenshots, outbox.screenshots);
  return taken;
}

std::optional<std::string> take_clipboard(Session& session) {
  return std::exchange(session.outbox->clipboard, std::nullopt);
}

std::vector<Notice> take_notices(Session& session) { return std::exchange(session.outbox->notices, {}); }

void note_frames_made(Session& session, std::size_t frames) {
  AnimationRun run = *session.jobs->animation;
  run.done = frames;
  session.jobs->animation = std::make_shared<const AnimationRun>(std::move(run));
}

void work_out(Session& session) { session.document->timeline.extend_to_end(); }

void make_whole(Session& session) {
  if (!session.document) return;
  work_out(session);              // so that the timeline in a picture is whole
  apply(session, PassTime{0.0});  // and its marks
  finish_pin(session);
  if (session.view->side == SidePanel::report) session.document->closeness = closeness_now(*session.document);
}

void show_position(Session& session, std::size_t position) { session.document->timeline.seek(position); }

void pin(Session& session, Pin pinned) { session.document->pinned = std::move(pinned); }

void forget_changes(Session& session) { session.document->changes = {}; }

}  // namespace app
