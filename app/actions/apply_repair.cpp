// Opening a mesh from a file, with repairs where they are asked for; the offer of repairs where it is unfit without; and
// the curves that it is cut along, where knitting begins and ends.
#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/actions/apply_parts.h"
#include "app/actions/hosting.h"
#include "app/actions/opening.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/presets.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"

namespace app {

namespace {

// The repaired mesh is shown; what was shown before can be come back to, but no further back.
void show_repaired(Session& session, Loaded loaded, const Source& source,
                   std::chrono::steady_clock::time_point start) {
  auto before = std::make_shared<Session>();
  before->view = session.view;
  before->jobs->repair_offer = session.jobs->repair_offer;
  before->outbox->notices = session.outbox->notices;
  before->document = show_loaded(session, std::move(loaded), source, start);
  if (before->document) before->document->before_repair.reset();
  session.document->before_repair = std::move(before);
}

// A preset that was chosen goes with the person to the next mesh.
struct ChosenPreset {
  const Preset* preset = nullptr;
  knit::Parameters parameters;
};

ChosenPreset preset_before(const Session& session) {
  if (!session.document) return {};
  const knit::Parameters& now = session.document->timeline.wished_parameters();
  return {chosen_preset(now, session.document->defaults), now};
}

void keep_preset(Session& session, const ChosenPreset& before) {
  if (before.preset == nullptr || !session.document) return;
  knit::Timeline& timeline = session.document->timeline;
  const knit::Parameters wanted = carried_over(*before.preset, before.parameters, timeline.base_parameters());
  if (knit::fault_of(wanted, timeline.input())) return;
  timeline.tune(wanted);
  notify(session, Notice::Kind::info,
         "The preset \"" + std::string(before.preset->title) +
             "\" counts for this mesh too; another is in the menu Presets.");
}

// Asked for by name, and nothing of that kind was there.
void tell_what_was_whole(Session& session, const knit::RepairWish& wish) {
  for (const knit::RepairKind kind : wish.kinds) {
    const auto& done = session.document->source.repairs;
    if (std::find(done.begin(), done.end(), kind) != done.end()) continue;
    notify(session, Notice::Kind::info,
           "The repair \"" + std::string(knit::key_of(kind)) + "\" found nothing to do on this mesh.");
  }
}

}  // namespace

// Where repairs would do it, they are offered, and the sentence stands in the offer instead of in a notice.
void show_opened(Session& session, std::variant<Loaded, NotOpened> opened, const std::filesystem::path& path,
                 const knit::RepairWish& repairs, std::chrono::steady_clock::time_point start) {
  const Source source{{}, path, {}};
  if (auto* loaded = std::get_if<Loaded>(&opened)) {
    const ChosenPreset before = preset_before(session);
    if (!loaded->repaired.empty() && session.document)
      show_repaired(session, std::move(*loaded), source, start);
    else
      show_loaded(session, std::move(*loaded), source, start);
    keep_preset(session, before);
    return tell_what_was_whole(session, repairs);
  }
  auto& unfit = std::get<NotOpened>(opened);
  // Of a piece that was chosen in the offer and cannot be made fit: the others are still to choose from.
  const bool was_offered = session.jobs->repair_offer && session.jobs->repair_offer->source.file == path;
  const bool stays = was_offered && repairs.piece() > 0;
  if (!stays || unfit.plan) session.jobs->repair_offer.reset();
  if (unfit.plan) {
    session.view->dialogs.open_dialog_open = false;
    session.jobs->repair_offer = RepairOffer{
        {{}, path, {}, std::move(unfit.curves)}, std::move(unfit.sentence), std::move(unfit.plan)};
  } else {
    notify(session, Notice::Kind::error, std::move(unfit.sentence));
  }
  note_not_opened(session, source);
}

void take(Session& session, const OpenFile& action) {
  cancel_opening(session);
  if (session.jobs->beside && is_long_to_open(action.path, false)) return begin_opening_mesh(session, action);
  const auto start = std::chrono::steady_clock::now();
  show_opened(session, open_mesh(action.path, action.repairs, nullptr, action.curves), action.path,
              action.repairs, start);
}

void take(Session& session, const RepairAndOpen& /*action*/) {
  if (!session.jobs->repair_offer) return;
  const auto start = std::chrono::steady_clock::now();
  const RepairOffer offer = *session.jobs->repair_offer;
  const auto opened = made_for(session, RepairAndOpen{},
                               {offer.source.file,
                                {offer.plan, knit::Weld::off, offer.source.curves},
                                offer.plan->mesh.triangles.size(),
                                [offer](knit::Progress* progress) {
                                  return load_repaired(*offer.plan, progress, offer.source.curves);
                                }});
  if (!opened) return;
  if (const auto* error = std::get_if<std::string>(&*opened)) {
    notify(session, Notice::Kind::error, *error);
    return;
  }
  const ChosenPreset before = preset_before(session);
  show_repaired(session, std::get<Loaded>(*opened), offer.source, start);
  keep_preset(session, before);
  session.view->list = RunList::problems;  // there it is said what was done
}

void take(Session& session, const DropRepairOffer& /*action*/) {
  give_up_making(session);
  session.jobs->repair_offer.reset();
}

// All else that was done since stays: what was set for the program, asked for or begun.
void take(Session& session, const UndoRepair& /*action*/) {
  if (!session.document) return;
  if (const auto before = session.document->before_repair) go_back_to(session, *before);
}

namespace {

// Vertices that were picked have other numbers once the mesh is cut otherwise.
void forget_picked(knit::Parameters& parameters) {
  parameters.timing.start = knit::no_vertex;
  parameters.timing.end = knit::no_vertex;
}

void cut_anew(Session& session, const Action& action, std::vector<knit::Cycle> curves) {
  Document& document = *session.document;
  if (document.source.curves == curves) return;
  give_up_making(session);
  Knobs knobs = knobs_of(document.timeline);
  forget_picked(knobs.base);
  for (knit::Edit& edit : knobs.edits) forget_picked(edit.parameters);
  const auto made = made_with(session, action, knobs.base, curves);
  if (!made) return;
  if (const auto* error = std::get_if<std::string>(&*made))
    return notify(session, Notice::Kind::error, *error);
  const auto& loaded = std::get<Loaded>(*made);
  knobs = resolved(knobs, *loaded.input);
  if (const auto fault = knit::fault_of(knobs.base, *loaded.input))
    return notify(session, Notice::Kind::error, *fault);
  note_other_change(document.changes, change_of(document));
  show_cut(session, loaded, knobs);
}

}  // namespace

void show_cut(Session& session, const Loaded& loaded, const Knobs& knobs) {
  Document& document = *session.document;
  document.source.curves = loaded.curves;
  document.findings = loaded.findings;
  document.timeline.set_knobs(knobs.base, knobs.edits, loaded.input);
  for (const knit::Finding& finding : document.findings)
    if (finding.kind == knit::FindingKind::cut_off) notify(session, Notice::Kind::warning, finding.sentence);
}

void take(Session& session, const SetCurves& action) {
  if (session.document) cut_anew(session, action, action.curves);
}

void take(Session& session, const AddCurve& action) {
  if (session.document) cut_anew(session, action, with_curve(session.document->source.curves, action.curve));
}

void take(Session& session, const RemoveCurve& action) {
  if (!session.document) return;
  std::vector<knit::Cycle> curves = session.document->source.curves;
  if (action.number < 1 || action.number > curves.size())
    return notify(session, Notice::Kind::error,
                  "There is no curve " + std::to_string(action.number) + "; the mesh is cut along " +
                      std::to_string(curves.size()) + ".");
  curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(action.number) - 1);
  cut_anew(session, action, std::move(curves));
}

void take(Session& session, const SwapCurves& action) {
  if (!session.document) return;
  std::vector<knit::Cycle> curves = session.document->source.curves;
  for (knit::Cycle& curve : curves) {
    curve.as = curve.as == knit::CycleEnd::start ? knit::CycleEnd::end : knit::CycleEnd::start;
    if (curve.value) curve.value = 1.0 - *curve.value;
  }
  cut_anew(session, action, std::move(curves));
}

void take(Session& session, const OpenCurves& action) {
  if (!session.document)
    return notify(session, Notice::Kind::error,
                  action.wish.file.string() + " holds curves; open the mesh first that they were drawn on.");
  auto curves = curves_for(action.wish, knit::bounds_of(session.document->original->positions));
  if (auto* error = std::get_if<std::string>(&curves))
    return notify(session, Notice::Kind::error, std::move(*error));
  cut_anew(session, action, std::get<0>(std::move(curves)));
}

}  // namespace app
