#include "knit/insight/knitted_remarks.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "knit/model/words.h"
#include "knit/relax/relax_stage.h"

namespace knit {

namespace {

constexpr double far_off = 0.05;                       // of the size asked for
constexpr double much_sunk = 0.5;                      // in h
constexpr double much_round = 1.2, much_longer = 1.4;  // times
constexpr double swollen = 1.25;                       // times the volume asked for
constexpr double lost_bend = 10.0;                     // degrees
constexpr std::size_t most_touching = 3;               // pairs of rows that are told one by one

class KnittedTold {
 public:
  KnittedTold(const Fabric& fabric, const KnittedPiece& piece, const Parameters& parameters)
      : fabric_(fabric), piece_(piece), made_(piece.figures), parameters_(parameters) {}

  std::vector<Remark> told() {
    if (is_without_size(piece_, parameters_)) {
      add(0, std::string(swelled_words));
      return std::move(remarks_);
    }
    size();
    ends();
    rounds();
    lengths();
    bends();
    touching();
    if (!piece_.relaxed.settled)
      add(0, "After " + plural(piece_.relaxed.iterations, "iteration", "iterations") +
                 " stitches still move by " + fixed_number(100.0 * piece_.relaxed.last_move, 1) +
                 " % of their width. More iterations bring it to rest.");
    return std::move(remarks_);
  }

 private:
  void add(RowId row, std::string words) {
    Remark remark{RemarkKind::knitted, std::move(words)};
    if (row > 0) remark.at = StitchRef{row, 0};
    remarks_.push_back(std::move(remark));
  }
  [[nodiscard]] std::string cm(double length) const {
    return fixed_number(length * parameters_.stitch.centimetres_per_unit, 1) + " cm";
  }

  void size() {
    const auto is_off = [](double knitted, double asked) {
      return std::abs(knitted - asked) > far_off * asked;
    };
    if (is_off(made_.knitted.height, made_.placed.height) || is_off(made_.knitted.width, made_.placed.width))
      add(0, comes_out_text(made_, parameters_) + "; the mesh asks for " + cm(made_.placed.height) + " and " +
                 cm(made_.placed.width) + ".");
    if (made_.volume_share > swollen)
      add(0,
          "Stuffed, it swells: it holds " + percent_text(made_.volume_share - 1.0) + " more than the mesh.");
  }
  void ends() {
    for (const bool first : {true, false}) {
      const double sunk = made_.sunk[first ? 0 : 1];
      if (sunk <= much_sunk * parameters_.stitch.height) continue;
      const double mm = 10.0 * sunk * parameters_.stitch.centimetres_per_unit;
      add(first ? 1 : fabric_.row_count(), std::string(first ? "The first" : "The last") +
                                               " row sinks in by " + fixed_number(mm, 0) +
                                               " mm: the rows beside it grow faster than a flat disc.");
    }
  }
  void rounds() {
    if (!made_.out_of_round || made_.out_of_round->share <= much_round) return;
    const RowId row = made_.out_of_round->row;
    add(row, "Row " + std::to_string(row) + " is out of round by " +
                 percent_text(made_.out_of_round->share - 1.0) +
                 ": shaping stands in the same wales, or it lies on a bend.");
  }
  void lengths() {
    if (made_.greatest.share <= much_longer) return;
    const RowId row = made_.greatest.row;
    add(row, "Stitches of row " + std::to_string(row) + " are stretched by " +
                 percent_text(made_.greatest.share - 1.0) + ".");
  }
  void bends() {
    if (made_.bend_placed - made_.bend_knitted > lost_bend)
      add(1, "The bend is lost: knitted in rounds this comes out straighter (" +
                 fixed_number(made_.bend_placed, 0) + " degrees become " +
                 fixed_number(made_.bend_knitted, 0) + "); short rows keep it.");
    for (const TurnedTube& tube : made_.turned)
      add(tube.row, "The tube that begins with row " + std::to_string(tube.row) + " turns by " +
                        fixed_number(tube.degrees, 0) +
                        " degrees: knitted, it stands otherwise than the mesh.");
  }
  void touching() {
    const std::size_t pairs = made_.touching.size();
    const std::size_t told = pairs > most_touching + 1 ? most_touching : pairs;
    for (std::size_t i = 0; i < told; ++i) {
      const auto& [low, high] = made_.touching[i];
      add(low, "Rows " + std::to_string(low) + " and " + std::to_string(high) + " touch.");
    }
    if (told == pairs) return;
    add(made_.touching[told][0],
        plural(static_cast<std::int64_t>(pairs - told), "more pair", "more pairs") + " of rows touch.");
  }

  const Fabric& fabric_;
  const KnittedPiece& piece_;
  const KnittedFigures& made_;
  const Parameters& parameters_;
  std::vector<Remark> remarks_;
};

}  // namespace

bool is_without_size(const KnittedPiece& piece, const Parameters& parameters) {
  return swelled_without_bound(piece.relaxed.iterations, piece.relaxed.settled, parameters.relax);
}

std::string comes_out_text(const KnittedFigures& figures, const Parameters& parameters) {
  const double cm = parameters.stitch.centimetres_per_unit;
  return std::string(parameters.relax.stuffing > 0.0 ? "Knitted and stuffed" : "Knitted") +
         ", this comes out " + fixed_number(figures.knitted.height * cm, 1) + " cm high and " +
         fixed_number(figures.knitted.width * cm, 1) + " cm wide";
}

std::string about_size_text(const KnittedFigures& figures, const Parameters& parameters) {
  const auto about = [&](double length) {
    const double cm = length * parameters.stitch.centimetres_per_unit, step = cm < 5.0 ? 0.1 : 0.5;
    return short_number(std::round(cm / step) * step) + " cm";
  };
  return std::string(parameters.relax.stuffing > 0.0 ? "Knitted and stuffed" : "Knitted") + ", about " +
         about(figures.knitted.height) + " high and " + about(figures.knitted.width) + " wide.";
}

std::vector<Remark> remarks_on(const Fabric& fabric, const KnittedPiece& piece,
                               const Parameters& parameters) {
  return KnittedTold(fabric, piece, parameters).told();
}

}  // namespace knit
