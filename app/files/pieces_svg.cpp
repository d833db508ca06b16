#include "app/files/pieces_svg.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "app/base/text.h"
#include "knit/model/words.h"
#include "knit/pattern/limb_needle.h"

namespace app {

namespace {

constexpr double gap_across = 4.0, gap_up = 13.0, pieces_edge = 4.0;
constexpr std::string_view order_colour = "#8a3d6d", thread_colour = "#555";

std::vector<PieceThread> threads_of(const knit::LimbPlan& plan) {
  const std::vector<knit::PieceNeedle> needles = knit::needles_of(plan);
  std::vector<PieceThread> threads;
  for (std::int32_t to = 0; to < plan.count(); ++to) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> counts;  // from, holder
    for (const knit::NeedleStitch& stitch : needles[static_cast<std::size_t>(to)].begin) {
      if (stitch.piece >= 0)
        ++counts[{stitch.piece, stitch.use == knit::NeedleUse::taken ? stitch.holder : -1}];
    }
    for (const auto& [way, stitches] : counts) {
      const bool goes_on = way.second < 0 && way.first + 1 == to;
      threads.push_back({way.first, to, stitches, way.second, goes_on, false});
    }
    const knit::LimbEnd& end = plan.piece(to).end;
    if (end.kind == knit::LimbEndKind::grafted)
      threads.push_back({end.piece, to, plan.piece(to).last_count(), -1, false, true});
  }
  return threads;
}

// Where a piece's neighbours in the layers beside stand on average; itself where it has none.
class Layers {
 public:
  explicit Layers(PiecesLayout& layout) : layout_(layout) {
    for (std::size_t piece = 0; piece < layout.places.size(); ++piece) {
      const auto layer = static_cast<std::size_t>(layout.places[piece].layer);
      if (layer >= layers_.size()) layers_.resize(layer + 1);
      layers_[layer].push_back(piece);
    }
  }

  void place() {
    constexpr int sweeps = 6;
    for (auto& layer : layers_) spread(layer);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (auto& layer : layers_) sort(layer);
      for (std::size_t i = layers_.size(); i-- > 0;) sort(layers_[i]);
    }
    for (int sweep = 0; sweep < 4 * sweeps; ++sweep) {
      for (auto& layer : layers_) pull(layer);
    }
    shift();
  }

 private:
  static constexpr double pitch = piece_box_width + gap_across;
  [[nodiscard]] double x(std::size_t piece) const { return layout_.places[piece].x; }

  [[nodiscard]] double wish(std::size_t piece) const {
    double sum = 0.0, count = 0.0;
    for (const PieceThread& thread : layout_.threads) {
      const auto from = static_cast<std::size_t>(thread.from), to = static_cast<std::size_t>(thread.to);
      if (from != piece && to != piece) continue;
      sum += x(from == piece ? to : from);
      count += 1.0;
    }
    return count > 0.0 ? sum / count : x(piece);
  }

  void spread(const std::vector<std::size_t>& layer) {
    for (std::size_t i = 0; i < layer.size(); ++i)
      layout_.places[layer[i]].x =
          pitch * (static_cast<double>(i) - 0.5 * static_cast<double>(layer.size() - 1));
  }

  void sort(std::vector<std::size_t>& layer) {
    std::vector<std::pair<double, std::size_t>> wishes;
    wishes.reserve(layer.size());
    for (const std::size_t piece : layer) wishes.emplace_back(wish(piece), piece);
    std::stable_sort(wishes.begin(), wishes.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first - 1e-9; });
    for (std::size_t i = 0; i < layer.size(); ++i) layer[i] = wishes[i].second;
    spread(layer);
  }

  // Towards the neighbours, the layer's order and distances kept: first as far right as wished, then pushed apart, then the
  // whole layer moved to the middle of what was wished.
  void pull(const std::vector<std::size_t>& layer) {
    std::vector<double> wished, placed;
    for (const std::size_t piece : layer) wished.push_back(wish(piece));
    for (std::size_t i = 0; i < layer.size(); ++i)
      placed.push_back(i == 0 ? wished[0] : std::max(wished[i], placed[i - 1] + pitch));
    double off = 0.0;
    for (std::size_t i = 0; i < layer.size(); ++i) off += placed[i] - wished[i];
    off /= static_cast<double>(layer.size());
    for (std::size_t i = 0; i < layer.size(); ++i) layout_.places[layer[i]].x = placed[i] - off;
  }

  void shift() {
    double low = 0.0, high = 0.0;
    for (std::size_t i = 0; i < layout_.places.size(); ++i) {
      low = i == 0 ? x(i) : std::min(low, x(i));
      high = i == 0 ? x(i) : std::max(high, x(i));
    }
    const auto layers = static_cast<double>(layers_.size());
    layout_.width = high - low + piece_box_width + 2.0 * pieces_edge;
    layout_.height = layers * piece_box_height + (layers - 1.0) * gap_up + 2.0 * pieces_edge + 4.0;
    for (PieceBox& box : layout_.places) {
      box.x += pieces_edge - low;
      box.y = layout_.height - pieces_edge - piece_box_height - box.layer * (piece_box_height + gap_up);
    }
  }

  PiecesLayout& layout_;
  std::vector<std::vector<std::size_t>> layers_;
};

}  // namespace

PiecesLayout layout_of(const knit::LimbPlan& plan) {
  PiecesLayout layout;
  layout.threads = threads_of(plan);
  layout.places.resize(plan.pieces.size());
  for (std::int32_t piece = 0; piece < plan.count(); ++piece) {
    std::int32_t& layer = layout.places[static_cast<std::size_t>(piece)].layer;
    for (const PieceThread& thread : layout.threads) {
      if (thread.to == piece && !thread.grafted)
        layer = std::max(layer, layout.places[static_cast<std::size_t>(thread.from)].layer + 1);
    }
  }
  Layers(layout).place();
  return layout;
}

namespace {

std::string mm(double value) { return trimmed_text(value, 2); }

struct PicturePoint {
  double x = 0.0, y = 0.0;
};

class PiecesPicture {
 public:
  PiecesPicture(const knit::LimbPlan& plan, const knit::LimbNames& names)
      : plan_(plan), names_(names), layout_(layout_of(plan)) {}

  [[nodiscard]] std::string document(const std::string& title) const {
    const double above = title.empty() ? 0.0 : 9.0, height = layout_.height + above + legend_height;
    const double width = std::max(layout_.width, 92.0);
    std::string out =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + mm(width) + "mm\" height=\"" + mm(height) +
        "mm\" viewBox=\"0 0 " + mm(width) + " " + mm(height) +
        "\" font-family=\"Inter, Helvetica, Arial, sans-serif\" fill=\"#222\" font-size=\"2.7\">\n";
    out += "<title>" + xml_text(title.empty() ? "The pieces in working order" : title) + "</title>\n";
    out +=
        "<defs><marker id=\"knit-order\" viewBox=\"0 0 4 4\" refX=\"3.6\" refY=\"2\" markerWidth=\"6\" "
        "markerHeight=\"6\" orient=\"auto\"><path d=\"M0 0L4 2L0 4Z\" fill=\"" +
        std::string(order_colour) + "\"/></marker></defs>\n";
    out += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    if (!title.empty())
      out += "<text x=\"" + mm(width / 2.0) +
             "\" y=\"6\" font-size=\"4.4\" font-weight=\"600\" text-anchor=\"middle\">" + xml_text(title) +
             "</text>\n";
    out += "<g transform=\"translate(" + mm((width - layout_.width) / 2.0) + " " + mm(above) + ")\">\n";
    for (const PieceThread& thread : layout_.threads) out += thread_line(thread);
    for (std::int32_t piece = 0; piece + 1 < plan_.count(); ++piece) out += order_arrow(piece);
    for (std::int32_t piece = 0; piece < plan_.count(); ++piece) out += box(piece);
    for (const PieceThread& thread : layout_.threads) out += holder(thread);
    return out + "</g>\n" + legend(width, height) + "</svg>\n";
  }

 private:
  static constexpr double legend_height = 7.0;

  [[nodiscard]] const PieceBox& at(std::int32_t piece) const {
    return layout_.places[static_cast<std::size_t>(piece)];
  }
  [[nodiscard]] PicturePoint middle(std::int32_t piece) const {
    return {at(piece).x + 0.5 * piece_box_width, at(piece).y + 0.5 * piece_box_height};
  }
  [[nodiscard]] PicturePoint top(std::int32_t piece) const {
    return {at(piece).x + 0.5 * piece_box_width, at(piece).y};
  }
  [[nodiscard]] PicturePoint bottom(std::int32_t piece) const {
    return {at(piece).x + 0.5 * piece_box_width, at(piece).y + piece_box_height};
  }
  static std::string point(const PicturePoint& p) { return mm(p.x) + " " + mm(p.y); }

  [[nodiscard]] std::string thread_line(const PieceThread& thread) const {
    const PicturePoint a = top(thread.from), b = thread.grafted ? top(thread.to) : bottom(thread.to);
    const double lift = thread.grafted ? std::min(a.y, b.y) - 6.0 : 0.5 * (a.y + b.y);
    const std::string path =
        "M" + point(a) + "C" + point({a.x, lift}) + " " + point({b.x, lift}) + " " + point(b);
    const bool yarn = thread.goes_on;
    return "<path class=\"thread\" d=\"" + path + "\" fill=\"none\" stroke=\"" +
           std::string(yarn ? order_colour : thread_colour) + "\" stroke-width=\"" + (yarn ? "1.1" : ".5") +
           "\"" + (thread.grafted ? " stroke-dasharray=\"1 1\"" : "") + "/>\n";
  }

  // Where the stitches wait: low, or high where several lines leave the piece.
  [[nodiscard]] std::string holder(const PieceThread& thread) const {
    if (thread.holder < 0) return {};
    const PicturePoint a = top(thread.from), b = bottom(thread.to);
    const auto leaving = std::count_if(layout_.threads.begin(), layout_.threads.end(),
                                       [&](const PieceThread& other) { return other.from == thread.from; });
    const double along = leaving > 1 ? 0.78 : 0.3;
    const double x = a.x + (b.x - a.x) * (3.0 - 2.0 * along) * along * along, y = a.y + (b.y - a.y) * along;
    const std::string words = knit::tube_name(thread.holder) + " " + std::to_string(thread.stitches);
    const double half = 1.3 + 0.85 * static_cast<double>(words.size());
    return "<rect class=\"holder\" x=\"" + mm(x - half) + "\" y=\"" + mm(y - 1.9) + "\" width=\"" +
           mm(2.0 * half) +
           "\" height=\"3.8\" rx=\"1.9\" fill=\"#fff\" stroke=\"#555\" stroke-width=\".3\"/>\n<text x=\"" +
           mm(x) + "\" y=\"" + mm(y + 0.95) + "\" text-anchor=\"middle\">" + words + "</text>\n";
  }

  // To the edge of the next box, unless the yarn goes on there: that line shows it.
  [[nodiscard]] std::string order_arrow(std::int32_t piece) const {
    for (const PieceThread& thread : layout_.threads) {
      if (thread.goes_on && thread.from == piece && thread.to == piece + 1) return {};
    }
    const PicturePoint from = middle(piece), to = middle(piece + 1);
    const double dx = to.x - from.x, dy = to.y - from.y;
    const double across = std::abs(dx) < 1e-9 ? 1e9 : 0.5 * piece_box_width / std::abs(dx);
    const double up = std::abs(dy) < 1e-9 ? 1e9 : 0.5 * piece_box_height / std::abs(dy);
    const double share = std::min({across, up, 0.5});
    const PicturePoint a{from.x + share * dx, from.y + share * dy}, b{to.x - share * dx, to.y - share * dy};
    return "<path class=\"order\" d=\"M" + point(a) + "L" + point(b) + "\" fill=\"none\" stroke=\"" +
           std::string(order_colour) +
           "\" stroke-width=\".35\" stroke-dasharray=\"1.4 .9\" marker-end=\"url(#knit-order)\"/>\n";
  }

  static std::string words_at(double x, double y, std::string_view look, const std::string& words) {
    return "<text x=\"" + mm(x) + "\" y=\"" + mm(y) + "\" text-anchor=\"middle\"" + std::string(look) + ">" +
           xml_text(words) + "</text>\n";
  }

  [[nodiscard]] std::string box(std::int32_t number) const {
    const knit::LimbPiece& piece = plan_.piece(number);
    const PieceBox& corner = at(number);
    const double x = corner.x + 0.5 * piece_box_width;
    std::string out = "<rect class=\"piece\" x=\"" + mm(corner.x) + "\" y=\"" + mm(corner.y) + "\" width=\"" +
                      mm(piece_box_width) + "\" height=\"" + mm(piece_box_height) + "\" rx=\"2\" fill=\"" +
                      (piece.inner ? "#eef3f8" : "#fbf7f4") + "\" stroke=\"#333\" stroke-width=\".4\"/>\n";
    const std::string name = names_(number);
    const double size =
        std::min(3.6, 1.75 * piece_box_width / static_cast<double>(std::max<std::size_t>(1, name.size())));
    out += words_at(x, corner.y + 7.6, " font-weight=\"600\" font-size=\"" + mm(size) + "\"", name);
    out += words_at(x, corner.y + 10.8, "", knit::plural(piece.round_count(), "rnd", "rnds"));
    out += words_at(x, corner.y + 3.2, " fill=\"#666\"", end_words(piece));
    return out + words_at(x, corner.y + piece_box_height - 1.2, " fill=\"#666\"", begin_words(piece));
  }

  static std::string end_words(const knit::LimbPiece& piece) {
    const std::string count = std::to_string(piece.last_count()) + (piece.last_count() == 1 ? " st" : " sts");
    return piece.end.kind == knit::LimbEndKind::closed ? count + ", closed" : count;
  }
  static std::string begin_words(const knit::LimbPiece& piece) {
    const std::string count = std::to_string(piece.first_count());
    if (piece.is_cast_on()) return "CO " + count;
    return count + (piece.first_count() == 1 ? " st" : " sts");
  }

  static std::string legend(double width, double height) {
    return "<text x=\"" + mm(width / 2.0) + "\" y=\"" + mm(height - 2.2) +
           "\" font-size=\"2.4\" fill=\"#555\" text-anchor=\"middle\">Work from A on, along the arrows; "
           "thick: the yarn "
           "goes on; in a ring: sts on a holder.</text>\n";
  }

  const knit::LimbPlan& plan_;
  const knit::LimbNames& names_;
  PiecesLayout layout_;
};

}  // namespace

std::string pieces_svg(const knit::LimbPlan& plan, const knit::LimbNames& names, const std::string& title) {
  return PiecesPicture(plan, names).document(title);
}

}  // namespace app
