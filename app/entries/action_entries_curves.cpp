// The curves where knitting begins and ends, in the list of all actions: typed as the command line takes them.
#include <string>
#include <utility>
#include <variant>

#include "app/base/text.h"
#include "app/entries/action_entries_parts.h"

namespace app {

namespace {

using Read = std::variant<Action, std::string>;

template <knit::CycleEnd as>
Read read_curve_typed(const Session& /*session*/, const std::string& typed) {
  auto curve = knit::parse_cycle(typed, as);
  if (auto* fault = std::get_if<std::string>(&curve)) return std::move(*fault);
  return AddCurve{std::get<knit::Cycle>(std::move(curve))};
}

Read read_curve_number(const Session& /*session*/, const std::string& typed) {
  const auto number = whole_number<std::size_t>(typed);
  if (number && *number >= 1) return RemoveCurve{*number};
  return "Curves are counted from 1, not \"" + typed + "\".";
}

Read read_curves_path(const Session& /*session*/, const std::string& typed) {
  if (typed.empty()) return "Give a file of curves: FILE.curves.json, or a .cons of autoknit.";
  return OpenCurves{CurveWish{typed, false, {}}};
}

}  // namespace

void add_curve_entries(EntryList& list) {
  const std::string none = list.unless_open();
  const bool any = list.session.document && !list.session.document->source.curves.empty();
  const std::string no_curves = any ? "" : "The mesh is cut along no curves.";
  constexpr const char* kinds = "boundary, circle, band, plane, path or farthest, or a vertex's number.";
  list.add({"Begin at the curve...", group::files, kinds,
            ActionPrompt{"Curve", "circle:0,1,0,0.5", read_curve_typed<knit::CycleEnd::start>}, none});
  list.add({"End at the curve...", group::files, kinds,
            ActionPrompt{"Curve", "farthest", read_curve_typed<knit::CycleEnd::end>}, none});
  list.add({"Remove the curve...", group::files, "Start and end are counted from 1.",
            ActionPrompt{"Number", "1", read_curve_number}, none});
  list.add({"Remove all curves", group::files, "The mesh is whole again.", SetCurves{},
            none.empty() ? no_curves : none});
  list.add(
      {"Swap the curves of start and end", group::files, "", SwapCurves{}, none.empty() ? no_curves : none});
  list.add({"Open curves...", group::files, "A file that saves where knitting begins and ends.",
            ActionPrompt{"Path", "mesh.curves.json", read_curves_path}, none});
}

}  // namespace app
