#include "app/session/pattern_pieces.h"

#include <algorithm>
#include <set>

#include "app/base/text.h"
#include "knit/pattern/limb_words.h"

namespace app {

bool is_piece_letter(std::string_view letters) {
  constexpr std::string_view capitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  return !letters.empty() && letters.size() <= 2 &&
         letters.find_first_not_of(capitals) == std::string_view::npos;
}

std::variant<std::pair<std::string, std::string>, std::string> read_piece_name(std::string_view text) {
  const std::size_t sign = text.find('=');
  const std::string_view letters = text.substr(0, sign);
  const std::string_view word = sign == std::string_view::npos ? std::string_view() : text.substr(sign + 1);
  if (is_piece_letter(letters) && knit::is_piece_word(word))
    return std::pair(std::string(letters), std::string(word));
  return "A piece's name cannot be \"" + std::string(text) +
         "\"; give its letter and one capitalised word: A=Tail.";
}

std::optional<std::string> fault_of_order(const std::vector<std::string>& order) {
  std::set<std::string> met;
  for (const std::string& letters : order) {
    if (!is_piece_letter(letters))
      return "\"" + letters + "\" is no piece's letter; give letters with commas between: B,A,C.";
    if (!met.insert(letters).second)
      return "Piece " + letters + " stands twice in the order; name each once.";
  }
  return std::nullopt;
}

std::variant<std::vector<std::string>, std::string> read_piece_order(std::string_view text) {
  std::vector<std::string> order;
  for (const std::string_view letters : split(text, ',')) order.emplace_back(letters);
  if (auto fault = fault_of_order(order)) return std::move(*fault);
  return order;
}

std::string piece_order_text(const std::vector<std::string>& order) {
  std::string text;
  for (const std::string& letters : order) text += (text.empty() ? "" : ",") + letters;
  return text;
}

}  // namespace app
