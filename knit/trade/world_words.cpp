#include "knit/trade/world_words.h"

#include <algorithm>
#include <array>

namespace knit {

namespace {

constexpr std::string_view cyc = "Craft Yarn Council", maps = "Stitch Maps", use = "published patterns";

constexpr std::array words{
    TradeWord{"k|knit", 1, 1, true, "knit", cyc},
    TradeWord{"p|purl", 1, 1, true, "purl", cyc},
    TradeWord{"sl|slip", 1, 1, true, "slip", cyc},
    TradeWord{"ktbl|ptbl|kb|pb|k1b|k-b", 1, 1, false, "knit or purl through the back loop", cyc},
    TradeWord{"mb|make bobble|bobble", 1, 1, false, "bobble, worked back to one stitch", cyc},
    TradeWord{"m1|make 1|m 1 st|m1l|m1r|m1a|m1b|m1t|m1z|m1f|m1k|m1p|m1pl|m1pr|m1lp|m1rp|mk1|make 1 left|make "
              "1 right|make 1 purlwise|make 1 st|ml|mr",
              0, 1, false, "make one between two stitches", cyc},
    TradeWord{"lli|rli|kll|krl|llinc|rlinc|pll|prl|rlpi|llpi", 0, 1, false, "lifted increase beside a stitch",
              cyc},
    TradeWord{"yo|yon|yrn|yfwd|yfrn|yfon|yf|yarn over|yarn forward|yarn round needle|wool forward|wfd", 0, 1,
              false, "yarn over", "Craft Yarn Council, UK usage"},
    TradeWord{"yo2|double yo|double yarn over|dyo|yo twice|y2rn|yo 2 times|yo x2", 0, 2, false,
              "yarn over twice", cyc},
    TradeWord{
        "kfb|k1fb|kf&b|k1f&b|kfab|k1fab|kf and b|k fb|inc kfb|bar inc|bar increase|pfb|p1fb|pf&b|pfab|kpf|"
        "kbf|k into front and back|knit into front and back|k in front and back|knit in front and back|p "
        "into front and back|purl into front and back|"
        "kp|k front and back|knit front and back|knit 1 front and back|k1 front and back|k1 in front and "
        "back|k1 into front and back|kllinc",
        1, 2, false, "knit or purl into front and back", cyc},
    TradeWord{"inc|increase|inc 1|increase 1|inc 1 st|increase 1 st", 1, 2, false,
              "increase, the way is free", cyc},
    TradeWord{"kfbf|kyok|kpk|pkp|k1yok1|k1 yo k1|kyk|p1yop1|inc 2|k1p1k1|m2|kfbf", 1, 3, false,
              "three out of one", cyc},
    TradeWord{"kfbfb|kyokyok|inc 4", 1, 5, false, "five out of one", use},
    TradeWord{"k2tog|knit 2 together|k2 together|knit 2tog|k2togtbl|k2tog tbl|k2 tog tbl|k2tog through back "
              "loops|p2tog|purl 2 together|p2 together|purl 2tog|p2togtbl|p2tog tbl|k2tbl tog|k tog 2|"
              "n1|dec|decrease|dec 1|decrease 1|dec 1 st|decrease 1 st",
              2, 1, false, "two together", cyc},
    TradeWord{"ssk|ssp|skp|skpo|sl1 k1 psso|sl1, k1, psso|slip 1, knit 1, psso|slip 1, k1, psso|slip 1 knit "
              "1 psso|sl1, k1, pass slipped stitch over|sl1, k1, pass slipped st over|slip 1, knit 1, pass "
              "slipped stitch over|slip 1, knit 1, pass slipped st over|"
              "slip slip knit|slip, slip, knit|slip slip purl|s1k1p|syk|kspo|sl, k, psso|sl1,k1,psso|sl1 "
              "wyib, k1, psso|slip st, k1, psso|yk2tog|sk1p|k2tog left|k2togl",
              2, 1, false, "two into one, leaning left", "Craft Yarn Council, UK usage"},
    TradeWord{"k3tog|knit 3 together|k3 together|k3togtbl|k3tog tbl|p3tog|purl 3 together|p3togtbl|p3tog "
              "tbl|p3 together",
              3, 1, false, "three together", cyc},
    TradeWord{
        "sssk|sssp|ssk2|sk2p|sk2po|s2kp|s2kp2|sl2kp|sl2k1p2|s2k1p2|s2kpo|cdd|dd|sl1, k2tog, psso|sl1 k2tog "
        "psso|slip 1, k2tog, psso|slip 1, knit 2 together, psso|slip 1, k2tog, pass slipped stitch over|slip "
        "1, knit 2 together, pass slipped stitch over|"
        "sl2, k1, p2sso|sl2 k1 p2sso|sl2tog, k1, psso|sl2 tog, k1, psso|sl2tog, k1, p2sso|slip 2, k1, "
        "p2sso|slip 2, knit 1, p2sso|slip 2, k1, pass slipped sts over|sl2, k1, psso|sl2 together, k1, psso|"
        "sl2 tog, k1, p2sso|sl2 as if to k2tog, k1, p2sso|sl1, k2tog, pass slipped st over|sk3p|slip slip "
        "slip knit|sl2togkpsso|sl2, k1, pass 2 slipped sts over",
        3, 1, false, "three into one", "Craft Yarn Council, Stitch Maps"},
    TradeWord{"k4tog|p4tog|k4togtbl|k4tog tbl|ssssk|knit 4 together", 4, 1, false, "four together", use},
    TradeWord{"k5tog|p5tog|k5togtbl|sl3, k2tog, p3sso|knit 5 together", 5, 1, false, "five together", use},
    TradeWord{"c2f|c2b|lt|rt|t2f|t2b|t2l|t2r|1/1lc|1/1rc|1/1lpc|1/1rpc|tw2|tw2l|tw2r|left twist|right "
              "twist|cr2|cr2l|cr2r",
              2, 2, false, "two stitches crossed", cyc},
    TradeWord{
        "c3f|c3b|t3f|t3b|2/1lc|2/1rc|1/2lc|1/2rc|2/1lpc|2/1rpc|1/2lpc|1/2rpc|1/1/1lc|1/1/1rc|c3l|c3r|t3l|t3r",
        3, 3, false, "three stitches crossed", cyc},
    TradeWord{"c4f|c4b|t4f|t4b|2/2lc|2/2rc|2/2lpc|2/2rpc|3/1lc|3/1rc|3/1lpc|3/1rpc|1/3lc|1/"
              "3rc|c4l|c4r|t4l|t4r|cable 4 front|cable 4 back|2/2 left cross|2/2 right cross",
              4, 4, false, "four stitches crossed", cyc},
    TradeWord{"c5f|c5b|t5f|t5b|3/2lc|3/2rc|2/3lc|2/3rc|3/2lpc|3/2rpc|2/1/2lc|2/1/2rc|t5l|t5r", 5, 5, false,
              "five stitches crossed", cyc},
    TradeWord{"c6f|c6b|3/3lc|3/3rc|3/3lpc|3/3rpc|4/2lc|4/2rc|2/2/2lc|2/2/2rc|c6l|c6r|cable 6 front|cable 6 "
              "back|3/3 left cross|3/3 right cross",
              6, 6, false, "six stitches crossed", cyc},
    TradeWord{"c8f|c8b|4/4lc|4/4rc|4/4lpc|4/4rpc|c8l|c8r|cable 8 front|cable 8 back", 8, 8, false,
              "eight stitches crossed", cyc},
    TradeWord{"c10f|c10b|5/5lc|5/5rc", 10, 10, false, "ten stitches crossed", maps},
    TradeWord{"c12f|c12b|6/6lc|6/6rc", 12, 12, false, "twelve stitches crossed", maps},
};

std::vector<std::string_view> parted(std::string_view forms) {
  std::vector<std::string_view> out;
  while (!forms.empty()) {
    const std::size_t end = std::min(forms.find('|'), forms.size());
    out.push_back(forms.substr(0, end));
    forms.remove_prefix(std::min(forms.size(), end + 1));
  }
  return out;
}

// The atoms a form takes up at `at`; 0: it does not stand there. Hyphens may stand anywhere in a word.
std::size_t fits(const Atoms& form, std::span<const Atom> atoms, std::size_t at) {
  std::size_t here = at;
  for (std::size_t i = 0; i < form.size(); ++i) {
    const bool comma_before = i > 0 && form[i - 1].is(",");
    if (i > 0 && here < atoms.size() && atoms[here].is("-") && !form[i].is("-")) ++here;
    if (here >= atoms.size() || !atoms[here].is(form[i].text)) {
      if (here >= atoms.size() || !form[i].is_number() || !atoms[here].is_number() ||
          atoms[here].value != form[i].value)
        return 0;
    }
    // "m1 p1" is two stitches, "m1p" one.
    const bool letter = is_any(form[i], {"k", "p", "s"});
    if (i > 0 && letter && !comma_before && form[i].glued && !atoms[here].glued) return 0;
    ++here;
  }
  // "k2tog" is not "k2togs", and "m1" not the beginning of "m1xyz".
  if (here < atoms.size() && atoms[here].glued && atoms[here].is_word() && !is_any(atoms[here], {"x", "tbl"}))
    return 0;
  return here - at;
}

std::size_t suffix_at(std::span<const Atom> atoms, std::size_t at) {
  std::size_t here = at;
  const auto is = [&](std::size_t ahead, AtomWords wanted) {
    return here + ahead < atoms.size() && is_any(atoms[here + ahead], wanted);
  };
  for (;;) {
    const std::size_t dash = is(0, {"-"}) ? 1 : 0;
    if (is(dash, {"tbl", "purlwise", "knitwise", "pwise", "kwise", "pw", "kw", "wyif", "wyib", "wyf", "wyb",
                  "pwyif", "pwyib", "kwyif"}))
      here += dash + 1;
    else if (is(0, {"through"}) && is(1, {"back"}) && is(2, {"loop", "loops", "lp", "lps"}))
      here += 3;
    else if ((is(0, {"with"}) && is(1, {"yarn"}) && is(2, {"in"}) && is(3, {"front", "back"})) ||
             (is(0, {"as"}) && is(1, {"if"}) && is(2, {"to"}) && is(3, {"knit", "purl"})))
      here += 4;
    else
      return here - at;
  }
}

}  // namespace

std::span<const TradeWord> trade_words() { return words; }

std::string trade_words_table() {
  std::string out = "| written | takes | makes | what it is | source |\n|---|---|---|---|---|\n";
  for (const TradeWord& word : words) {
    std::string forms;
    for (const std::string_view form : parted(word.forms))
      forms += (forms.empty() ? "" : " · ") + std::string(form);
    out += "| " + forms + " | " + std::to_string(word.takes) + " | " + std::to_string(word.makes) + " | " +
           std::string(word.meaning) + " | " + std::string(word.source) + " |\n";
  }
  return out;
}

Lexicon::Lexicon() {
  for (std::size_t i = 0; i < words.size(); ++i) {
    for (const std::string_view form : parted(words[i].forms)) {
      Form made{atoms_of(form), i};
      by_first_[made.atoms.front().text].push_back(std::move(made));
    }
  }
}

std::optional<MatchedWord> Lexicon::match(std::span<const Atom> atoms, std::size_t at) const {
  if (at >= atoms.size()) return std::nullopt;
  const auto forms = by_first_.find(atoms[at].text);
  if (forms == by_first_.end()) return std::nullopt;
  std::size_t longest = 0, word = 0;
  for (const Form& form : forms->second) {
    const std::size_t length = fits(form.atoms, atoms, at);
    if (length > longest) longest = length, word = form.word;
  }
  if (longest == 0) return std::nullopt;
  const TradeWord& found = words[word];
  MatchedWord matched{
      found.takes, found.makes, found.counts, word < 2, found.meaning.starts_with("increase,"), longest};
  if (!found.counts) matched.atoms += suffix_at(atoms, at + longest);
  return matched;
}

}  // namespace knit
