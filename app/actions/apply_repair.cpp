// Opening a mesh from a file, with mends where they are asked for; the offer of mends where it is unfit without.
#include <algorithm>
#include <chrono>

#include "app/actions/apply_parts.h"
#include "app/actions/opening.h"

namespace app {

namespace {

// What is open, to come back to; its own way back is given up. Until something else is shown nothing is open.
std::shared_ptr<const Session> put_by(Session& session) {
  // The run is moved: a copy of a long one is dear.
  std::optional<knit::Timeline> timeline = std::move(session.timeline);
  session.timeline.reset();
  auto before = std::make_shared<Session>(session);
  before->timeline = std::move(timeline);
  before->before_mend.reset();
  before->made_mesh.reset();
  return before;
}

// Asked for by name, and nothing of that kind was there.
void tell_what_was_whole(Session& session, const knit::MendWish& wish) {
  for (const knit::MendKind kind : wish.kinds) {
    const auto& done = session.source.mends;
    if (std::find(done.begin(), done.end(), kind) != done.end()) continue;
    session.notices.push_back({Notice::Kind::info, "The mend \"" + std::string(knit::key_of(kind)) +
                                                       "\" found nothing to do on this mesh."});
  }
}

}  // namespace

// Where mends would do it, they are offered, and the sentence stands in the offer instead of in a notice.
void show_opened(Session& session, std::variant<Loaded, NotOpened> opened, const std::filesystem::path& path,
                 const knit::MendWish& mends, std::chrono::steady_clock::time_point start) {
  const Source source{{}, path, {}};
  if (auto* loaded = std::get_if<Loaded>(&opened)) {
    const bool mended = !loaded->mended.empty() && session.timeline;
    auto before = mended ? put_by(session) : nullptr;
    show_loaded(session, std::move(*loaded), source, start);
    session.before_mend = std::move(before);
    return tell_what_was_whole(session, mends);
  }
  auto& unfit = std::get<NotOpened>(opened);
  session.mend_offer.reset();
  if (unfit.plan) {
    session.open_dialog_open = false;
    session.mend_offer = MendOffer{source, std::move(unfit.sentence), std::move(unfit.plan)};
  } else {
    session.notices.push_back({Notice::Kind::error, std::move(unfit.sentence)});
  }
  note_not_opened(session, source);
}

void take(Session& session, const OpenFile& action) {
  cancel_opening(session);
  if (session.beside && is_long_to_open(action.path, false))
    return begin_opening_mesh(session, action.path, action.mends);
  const auto start = std::chrono::steady_clock::now();
  show_opened(session, open_mesh(action.path, action.mends), action.path, action.mends, start);
}

void take(Session& session, const MendAndOpen& /*action*/) {
  if (!session.mend_offer) return;
  const auto start = std::chrono::steady_clock::now();
  const MendOffer offer = *session.mend_offer;
  const auto opened =
      made_for(session, MendAndOpen{},
               {offer.source.file, offer.plan, knit::Weld::off, offer.plan->mesh.triangles.size(),
                [plan = offer.plan](knit::Progress* progress) { return load_mended(*plan, progress); }});
  if (!opened) return;
  if (const auto* error = std::get_if<std::string>(&*opened)) {
    session.notices.push_back({Notice::Kind::error, *error});
    return;
  }
  auto before = put_by(session);
  show_loaded(session, std::get<Loaded>(*opened), offer.source, start);
  session.before_mend = std::move(before);
  session.list = RunList::problems;  // there it is said what was done
}

void take(Session& session, const DropMendOffer& /*action*/) {
  give_up_making(session);
  session.mend_offer.reset();
}

// What the person has set for the program since stays; so does what is still to be done after this frame.
void take(Session& session, const UndoMend& /*action*/) {
  if (!session.before_mend) return;
  Session before = *session.before_mend;
  before.beside = session.beside;
  before.preferences = session.preferences;
  before.aspect = session.aspect;
  before.rescued = session.rescued;
  before.quit = session.quit;
  before.figures_wanted = session.figures_wanted;
  before.pages_wanted = session.pages_wanted;
  before.screenshots_wanted = session.screenshots_wanted;
  before.clipboard_wanted = session.clipboard_wanted;
  session = std::move(before);
}

}  // namespace app
