#include "knit/stitches/pattern.h"

#include <span>

namespace knit {

namespace {

struct Word {
  std::string_view text;
  std::int32_t consumes, produces;
};

Word word_of(Label label) {
  switch (label) {
    case Label::m1r:
      return {"m1r", 0, 1};
    case Label::m1l:
      return {"m1l", 0, 1};
    case Label::k2tog:
      return {"k2tog", 2, 1};
    case Label::ssk:
      return {"ssk", 2, 1};
    default:
      return {"k", 1, 1};
  }
}

// Words joined by commas, plain stitches counted together, the line's own sums kept.
class LineWriter {
 public:
  void knit() {
    ++plain_;
    add({"k", 1, 1});
  }
  void say(const Word& word, bool at_main) {
    flush();
    words_ += words_.empty() ? "" : ", ";
    words_ += word.text;
    if (word.text == "k") words_ += '1';
    if (at_main) words_ += " (m)";
    add(word);
  }
  std::string finish() {
    flush();
    return words_;
  }
  [[nodiscard]] std::int32_t consumed() const { return consumed_; }
  [[nodiscard]] std::int32_t produced() const { return produced_; }

 private:
  void add(const Word& word) {
    consumed_ += word.consumes;
    produced_ += word.produces;
  }
  void flush() {
    if (plain_ == 0) return;
    words_ += words_.empty() ? "" : ", ";
    words_ += "k" + std::to_string(plain_);
    plain_ = 0;
  }

  std::string words_;
  std::int32_t plain_ = 0, consumed_ = 0, produced_ = 0;
};

// Cells that a decrease takes in: they are part of its word.
std::vector<std::uint8_t> absorbed_cells(const Join& t) {
  std::vector<std::uint8_t> absorbed(t.labels.size(), 0);
  for (std::size_t cell = 0; cell < t.labels.size(); ++cell) {
    if (is_decrease(t.labels[cell])) absorbed[static_cast<std::size_t>(t.partner[cell])] = 1;
  }
  return absorbed;
}

std::string counted(std::int32_t stitches) {
  return " (" + std::to_string(stitches) + (stitches == 1 ? " st)" : " sts)");
}

}  // namespace

PatternLine cast_on_line(std::int32_t stitches) {
  return {1, "Rnd 1: CO " + std::to_string(stitches) + ". Join to work in the round." + counted(stitches), 0,
          stitches};
}

PatternLine round_line(const Join& join) {
  const std::vector<std::uint8_t> absorbed = absorbed_cells(join);
  LineWriter line;
  bool plain = true;
  for (std::size_t cell = 0; cell < join.labels.size(); ++cell) {
    const Label label = join.labels[cell];
    if (is_shaping(label)) {
      const bool at_main =
          is_decrease(label) && join.labels[static_cast<std::size_t>(join.partner[cell])] == Label::main;
      line.say(word_of(label), at_main);
      plain = false;
    } else if (absorbed[cell] != 0) {
      continue;
    } else if (label == Label::main && join.change() != 0) {
      line.say(word_of(label), true);
    } else {
      line.knit();
    }
  }
  std::string words = line.finish();
  if (plain) words = "Knit";
  return {join.to, "Rnd " + std::to_string(join.to) + ": " + words + "." + counted(line.produced()),
          line.consumed(), line.produced()};
}

PatternLine bind_off_line(std::int32_t row, std::int32_t stitches) {
  return {row, "BO " + std::to_string(stitches) + ".", stitches, 0};
}

std::vector<LabelRow> appendix_view(std::int32_t cast_on, std::span<const Join* const> joins, bool complete) {
  std::vector<LabelRow> view;
  const auto cast = [](std::int32_t size) {
    return std::vector<Label>(static_cast<std::size_t>(size), Label::cast);
  };
  view.push_back({1, std::nullopt, cast(cast_on)});
  for (std::size_t i = 0; i < joins.size(); ++i) {
    const Join& t = *joins[i];
    const bool last = complete && i + 1 == joins.size();
    if (t.change() < 0) {
      // Decreases are labelled in the row they start from: in its own list where that is plain.
      const bool plain_below = i > 0 && joins[i - 1]->change() <= 0;
      if (plain_below) {
        view.back().labels = t.labels;
      } else {
        view.push_back({view.back().row, t.to, t.labels});
      }
      std::vector<Label> carried(static_cast<std::size_t>(t.above), Label::knit);
      for (const std::int32_t main : t.mains) carried[static_cast<std::size_t>(main)] = Label::main;
      view.push_back({t.to, std::nullopt, last ? cast(t.above) : std::move(carried)});
    } else {
      view.push_back({t.to, std::nullopt, last && t.change() == 0 ? cast(t.above) : t.labels});
    }
  }
  return view;
}

std::string text_of(const LabelRow& row) {
  std::string text = std::to_string(row.row);
  if (row.into) text += " > " + std::to_string(*row.into);
  text += ": [";
  for (std::size_t i = 0; i < row.labels.size(); ++i) {
    if (i > 0) text += ", ";
    text += std::to_string(static_cast<int>(row.labels[i]));
  }
  return text + "]";
}

}  // namespace knit
