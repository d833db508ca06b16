#include "knit/reader/limbs_lines.h"

#include <algorithm>

namespace knit {

namespace {

constexpr std::size_t most_lines_of_remark = 8, longest_sentence = 20000;

bool is_title(std::string_view line, std::string_view wanted) {
  return std::equal(line.begin(), line.end(), wanted.begin(), wanted.end(),
                    [](char a, char b) { return lower(a) == lower(b); });
}

int depth_of(std::string_view text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '(') -
                          std::count(text.begin(), text.end(), ')'));
}

// "B, C and D" after one word.
std::optional<std::vector<LimbName>> letters_of(LimbScan& at, const std::string& word) {
  std::vector<LimbName> names;
  while (true) {
    const auto letters = at.capitals();
    if (!letters) return std::nullopt;
    names.push_back({word, *letters, 1});
    if (!at.take(", ") && !at.take(" and ")) return names;
  }
}

bool begins_line(std::string_view text) { return limb_heading_of(text) || label_at(text, 0); }

// Sentences that go on on the next lines: a list after a colon or a comma, a remark whose bracket is open.
std::vector<TextLine> sentences_of(std::vector<TextLine> lines) {
  std::vector<TextLine> sentences;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    TextLine sentence = std::move(lines[i]);
    const bool remark = sentence.text.starts_with("(");
    std::size_t taken = 1;
    const auto goes_on = [&] {
      if (i + 1 >= lines.size() || sentence.text.size() > longest_sentence || begins_line(lines[i + 1].text))
        return false;
      if (remark) return depth_of(sentence.text) > 0 && taken < most_lines_of_remark;
      return sentence.text.ends_with(",") || sentence.text.ends_with(":");
    };
    while (goes_on()) {
      sentence.text += " " + lines[++i].text;
      ++taken;
    }
    sentences.push_back(std::move(sentence));
  }
  return sentences;
}

}  // namespace

std::string several(const std::string& word) {
  const auto vowel = [](char c) { return std::string_view("aeiou").find(c) != std::string_view::npos; };
  if (word == "Foot") return "Feet";
  if (word.size() > 1 && word.back() == 'y' && !vowel(word[word.size() - 2]))
    return word.substr(0, word.size() - 1) + "ies";
  for (const std::string_view hiss : {"s", "x", "ch", "sh"}) {
    if (word.ends_with(hiss)) return word + "es";
  }
  return word + "s";
}

std::string one_of_several(const std::string& word) {
  const auto without = [&](std::size_t letters) { return word.substr(0, word.size() - letters); };
  if (word == "Feet") return "Foot";
  if (word.ends_with("ies")) return without(3) + "y";
  for (const std::string_view hiss : {"xes", "ches", "shes"}) {
    if (word.ends_with(hiss)) return without(2);
  }
  return word.ends_with("s") ? without(1) : word;
}

std::optional<std::vector<LimbName>> limb_list(LimbScan& at) {
  std::vector<LimbName> names;
  while (true) {
    const auto name = at.holder();
    if (!name) return std::nullopt;
    names.push_back(*name);
    if (!at.take(", ") && !at.take(" and ")) return names;
  }
}

std::optional<LimbHeading> limb_heading_of(std::string_view line) {
  LimbScan at(line);
  LimbHeading heading;
  const auto word = at.word();
  if (!word || !at.take(" ")) return std::nullopt;
  auto names = letters_of(at, *word);
  if (!names) return std::nullopt;
  heading.names = std::move(*names);
  if (at.take(" (make ")) {
    const auto made = at.number();
    if (!made || !at.take(")")) return std::nullopt;
    heading.made = *made;
  }
  if (!at.take(": ")) return std::nullopt;
  const auto rounds = at.number();
  if (!rounds || !at.take(*rounds == 1 ? " rnd, " : " rnds, ")) return std::nullopt;
  const auto stitches = at.stitches();
  if (!stitches || !at.take(" at the end") || !at.done()) return std::nullopt;
  heading.rounds = *rounds;
  heading.stitches = *stitches;
  return heading;
}

std::optional<LimbLabel> limb_label_of(std::string_view line) {
  LimbScan at(line);
  const auto word = at.word();
  if (!word || !at.take(" ")) return std::nullopt;
  auto names = letters_of(at, *word);
  if (!names || !at.take(": ")) return std::nullopt;
  return LimbLabel{std::move(*names), at.rest()};
}

LimbSections limb_sections_of(std::string_view text) {
  std::vector<TextLine> lines = pattern_lines(text);
  LimbSections found;
  found.last_line = lines.empty() ? 1 : lines.back().number;
  const auto titled = [&](std::string_view title) {
    return std::find_if(lines.begin(), lines.end(),
                        [&](const TextLine& line) { return is_title(line.text, title); });
  };
  if (const auto begin = titled("instructions"); begin != lines.end())
    lines.erase(lines.begin(), begin + 1);
  else
    lines.erase(lines.begin(), std::find_if(lines.begin(), lines.end(),
                                            [](const TextLine& line) { return begins_line(line.text); }));
  if (const auto end = titled("finishing"); end != lines.end()) lines.erase(end, lines.end());
  for (TextLine& line : sentences_of(std::move(lines))) {
    if (line.text.starts_with("(")) continue;
    if (auto heading = limb_heading_of(line.text)) {
      found.sections.push_back({line.number, std::move(*heading), {}});
    } else if (!found.sections.empty()) {
      found.sections.back().lines.push_back(std::move(line));
    } else if (!found.stray) {
      found.stray = std::move(line);
    }
  }
  return found;
}

}  // namespace knit
