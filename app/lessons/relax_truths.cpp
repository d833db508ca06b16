// What is right about the piece off the needles: its size beside the one asked for, and how far its ends sink in.
#include <string_view>

#include "app/lessons/lesson_truths.h"
#include "app/session/document.h"
#include "knit/model/words.h"
#include "knit/relax/knitted.h"

namespace app::truths {

namespace {

// A number as it is told, and how far off an answer may be: what people read off a rounded one.
Truth told(double number, double slack, std::string_view unit, const std::string& what) {
  const std::string words = knit::short_number(number);
  return {{words}, what + " " + words + " " + std::string(unit) + ".", slack};
}

}  // namespace

Truth knitted_size(const Session& session, const JudgeCall& call) {
  constexpr double slack_cm = 0.11, slack_mm = 0.6;
  const knit::Timeline& timeline = session.document->timeline;
  const double cm = timeline.parameters().stitch.centimetres_per_unit;
  if (call.word == "asked-height")
    return told(timeline.parameters().size.height_cm, slack_cm, "cm", "The height asked for is");
  if (!timeline.complete()) return not_yet();
  const auto& piece = timeline.furthest().relaxed;
  if (!piece) return untold("This run stays on the needles; set the page up again.");
  const knit::KnittedFigures& made = piece->figures;
  if (call.word == "height")
    return told(made.knitted.height * cm, slack_cm, "cm", "Off the needles and stuffed, it is as high as");
  if (call.word == "width")
    return told(made.knitted.width * cm, slack_cm, "cm", "Off the needles and stuffed, it is as wide as");
  const bool first = call.word == "first-sunk";
  return told(
      made.sunk[first ? 0 : 1] * cm * 10.0, slack_mm, "mm",
      first ? "The first row lies below the piece's end by" : "The last row lies below the piece's end by");
}

}  // namespace app::truths
