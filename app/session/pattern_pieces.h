// What a person says about the pieces of a pattern with limbs: what each is called, and in which order they are worked.
//
// A piece goes by the letter that it has in the cheapest order. In the pattern pieces are lettered as they are worked: after
// another order was chosen those letters are others, and names stay with their pieces.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace app {

struct PatternPieces {
  std::map<std::string, std::string> names;  // {"A", "Tail"}; one capitalised word each
  std::vector<std::string> order;            // {"B", "A", "C"}; empty: the cheapest
  friend bool operator==(const PatternPieces&, const PatternPieces&) = default;
};

// "A", "AB": one capital letter or two.
bool is_piece_letter(std::string_view letters);

// "A=Tail"; the error is one sentence.
std::variant<std::pair<std::string, std::string>, std::string> read_piece_name(std::string_view text);
// "B,A,C"; the error is one sentence. Whether it is an order of the run's pieces only the run knows.
std::variant<std::vector<std::string>, std::string> read_piece_order(std::string_view text);
std::string piece_order_text(const std::vector<std::string>& order);  // "B,A,C"

// What is wrong with it by itself; nothing: nothing.
std::optional<std::string> fault_of_order(const std::vector<std::string>& order);

}  // namespace app
