// Opening a mesh from a file, with mends where they are asked for; the offer of mends where it is unfit without.
#include <algorithm>
#include <chrono>

#include "app/actions/apply_parts.h"
#include "app/actions/hosting.h"
#include "app/actions/opening.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/view.h"

namespace app {

namespace {

// The mended mesh is shown; what was shown before can be come back to, but no further back.
void show_mended(Session& session, Loaded loaded, const Source& source,
                 std::chrono::steady_clock::time_point start) {
  auto before = std::make_shared<Session>();
  before->view = session.view;
  before->jobs->mend_offer = session.jobs->mend_offer;
  before->outbox->notices = session.outbox->notices;
  before->document = show_loaded(session, std::move(loaded), source, start);
  if (before->document) before->document->before_mend.reset();
  session.document->before_mend = std::move(before);
}

// Asked for by name, and nothing of that kind was there.
void tell_what_was_whole(Session& session, const knit::MendWish& wish) {
  for (const knit::MendKind kind : wish.kinds) {
    const auto& done = session.document->source.mends;
    if (std::find(done.begin(), done.end(), kind) != done.end()) continue;
    notify(session, Notice::Kind::info,
           "The mend \"" + std::string(knit::key_of(kind)) + "\" found nothing to do on this mesh.");
  }
}

}  // namespace

// Where mends would do it, they are offered, and the sentence stands in the offer instead of in a notice.
void show_opened(Session& session, std::variant<Loaded, NotOpened> opened, const std::filesystem::path& path,
                 const knit::MendWish& mends, std::chrono::steady_clock::time_point start) {
  const Source source{{}, path, {}};
  if (auto* loaded = std::get_if<Loaded>(&opened)) {
    if (!loaded->mended.empty() && session.document)
      show_mended(session, std::move(*loaded), source, start);
    else
      show_loaded(session, std::move(*loaded), source, start);
    return tell_what_was_whole(session, mends);
  }
  auto& unfit = std::get<NotOpened>(opened);
  session.jobs->mend_offer.reset();
  if (unfit.plan) {
    session.view->dialogs.open_dialog_open = false;
    session.jobs->mend_offer = MendOffer{source, std::move(unfit.sentence), std::move(unfit.plan)};
  } else {
    notify(session, Notice::Kind::error, std::move(unfit.sentence));
  }
  note_not_opened(session, source);
}

void take(Session& session, const OpenFile& action) {
  cancel_opening(session);
  if (session.jobs->beside && is_long_to_open(action.path, false))
    return begin_opening_mesh(session, action.path, action.mends);
  const auto start = std::chrono::steady_clock::now();
  show_opened(session, open_mesh(action.path, action.mends), action.path, action.mends, start);
}

void take(Session& session, const MendAndOpen& /*action*/) {
  if (!session.jobs->mend_offer) return;
  const auto start = std::chrono::steady_clock::now();
  const MendOffer offer = *session.jobs->mend_offer;
  const auto opened =
      made_for(session, MendAndOpen{},
               {offer.source.file, offer.plan, knit::Weld::off, offer.plan->mesh.triangles.size(),
                [plan = offer.plan](knit::Progress* progress) { return load_mended(*plan, progress); }});
  if (!opened) return;
  if (const auto* error = std::get_if<std::string>(&*opened)) {
    notify(session, Notice::Kind::error, *error);
    return;
  }
  show_mended(session, std::get<Loaded>(*opened), offer.source, start);
  session.view->list = RunList::problems;  // there it is said what was done
}

void take(Session& session, const DropMendOffer& /*action*/) {
  give_up_making(session);
  session.jobs->mend_offer.reset();
}

// All else that was done since stays: what was set for the program, asked for or begun.
void take(Session& session, const UndoMend& /*action*/) {
  if (!session.document) return;
  if (const auto before = session.document->before_mend) go_back_to(session, *before);
}

}  // namespace app
