// The sentences of a pattern with limbs: names, deals, ends. Their grammar is in docs/pattern.md; the reader
// (knit/reader/limbs_reader.h) knows them by itself.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "knit/pattern/written_pattern.h"

namespace knit {

// A capital letter and small ones: what stands before a piece's letter, "Tail A".
bool is_piece_word(std::string_view word);

class LimbNames {
 public:
  LimbNames(const LimbPlan& plan, const PatternOptions& options);
  [[nodiscard]] const std::string& word(std::int32_t piece) const {
    return words_[static_cast<std::size_t>(piece)];
  }
  [[nodiscard]] std::string operator()(std::int32_t piece) const;  // "Limb B"
  [[nodiscard]] std::string holder(std::int32_t piece,
                                   std::int32_t number) const;  // "Limb B", "Limb B (holder 2)"
  [[nodiscard]] std::string together(
      const std::vector<std::int32_t>& pieces) const;  // one word: "Limbs B and C"
  [[nodiscard]] std::string listed(
      const std::vector<std::int32_t>& pieces) const;  // "Limb A, Limb B and Body C"

 private:
  std::vector<std::string> words_;
};

// "Limbs", "Branches", "Bodies"
std::string plural_of(const std::string& word);

// What lies on the needle; of a cast on nothing: that is a round.
std::string deal_sentence(const LimbPlan& plan, const LimbNames& names, const LimbDeal& deal);
std::string cast_on_words(const LimbDeal& deal);  // "CO 5 sts. Join in the round, place marker"
std::string end_sentence(const LimbPlan& plan, const LimbNames& names, const LimbPiece& piece);
// What the holders that a join takes go by, in that order.
std::string holders_joined(const LimbNames& names, const LimbDeal& deal);

}  // namespace knit
