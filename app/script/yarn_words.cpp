#include "app/script/yarn_words.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/base/text.h"
#include "app/scene/colour_text.h"
#include "app/session/action.h"
#include "knit/import/quoting.h"
#include "knit/model/settings_table.h"
#include "knit/yarn/eased_yarn.h"

namespace app {

namespace {

std::string layer_list() {
  std::string list;
  for (std::size_t i = 0; i < layer_count; ++i)
    list += (list.empty() ? "" : ", ") + std::string(key_of(static_cast<Layer>(i)));
  return list;
}

std::optional<std::string> read_layers(const std::string& words, YarnWish& wish) {
  if (words.empty()) return std::nullopt;
  std::array<bool, layer_count> layers{};
  if (words != "none") {
    for (const std::string_view word : split(words, ',')) {
      std::size_t i = 0;
      while (i < layer_count && key_of(static_cast<Layer>(i)) != word) ++i;
      if (i == layer_count)
        return "--layers cannot be " + knit::quoted(words) + ": there is no layer " +
               knit::quoted(std::string(word)) + "; give none, or some of " + layer_list() + ".";
      layers.at(i) = true;
    }
  }
  wish.layers = layers;
  return std::nullopt;
}

template <class Kind, std::size_t count>
std::optional<std::string> choose_word(const char* option, const std::string& word,
                                       const std::array<std::string_view, count>& names,
                                       std::optional<Kind>& chosen) {
  if (word.empty()) return std::nullopt;
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end())
    return std::string(option) + " cannot be " + knit::quoted(word) + "; give " + one_of(names) + ".";
  chosen = static_cast<Kind>(found - names.begin());
  return std::nullopt;
}

std::optional<std::string> read_count(const char* option, const std::string& word, const char* of, int most,
                                      std::optional<int>& count) {
  if (word.empty()) return std::nullopt;
  count = whole_number<int>(word);
  if (count && *count >= 0 && *count <= most) return std::nullopt;
  return std::string(option) + " cannot be " + knit::quoted(word) + "; give a number of " + of +
         " from 0 to " + std::to_string(most) + ".";
}

std::optional<std::string> read_colour_word(const char* option, const std::string& word,
                                            std::optional<Colour>& colour) {
  if (word.empty()) return std::nullopt;
  colour = colour_of_hex(word);
  if (colour) return std::nullopt;
  return std::string(option) + " cannot be " + knit::quoted(word) + "; give a colour like #d8b48c.";
}

}  // namespace

void declare_yarn(CLI::App& app, YarnWords& words) {
  app.add_option("--layers", words.layers,
                 "what the view shows, as A,B, and nothing else: " + layer_list() + "; or none");
  app.add_option("--show-as", words.show_as, "sets layers and positions together: " + one_of(looking_keys));
  app.add_option("--yarn-colour", words.colour, "the drawn yarn's colour, like #d8b48c");
  app.add_option("--yarn-second", words.second, "the second colour of its stripes");
  app.add_option("--yarn-stripes", words.stripes, "so many rounds of each colour by turns; 0: no stripes");
  app.add_option("--yarn-radius", words.radius, "its radius in widths of a stitch, or auto: an eighth");
  app.add_option("--yarn-relax", words.easing,
                 "iterations that make room where its loops overlap; 30 are enough, 0: none");
  app.add_option("--yarn-shows", words.shows, "what its colour tells: " + one_of(yarn_colours_keys));
}

std::optional<std::string> read_yarn_words(const YarnWords& words, YarnWish& wish) {
  if (auto fault = read_layers(words.layers, wish)) return fault;
  if (auto fault = choose_word("--show-as", words.show_as, looking_keys, wish.looking)) return fault;
  if (auto fault = choose_word("--yarn-shows", words.shows, yarn_colours_keys, wish.by)) return fault;
  if (auto fault = read_colour_word("--yarn-colour", words.colour, wish.wool)) return fault;
  if (auto fault = read_colour_word("--yarn-second", words.second, wish.second)) return fault;
  if (auto fault =
          read_count("--yarn-stripes", words.stripes, "rounds", most_stripe_rounds, wish.stripe_rounds))
    return fault;
  if (auto fault =
          read_count("--yarn-relax", words.easing, "iterations", knit::most_yarn_easing, wish.easing))
    return fault;
  if (words.radius.empty()) return std::nullopt;
  wish.radius = read_yarn_radius(words.radius);
  if (wish.radius) return std::nullopt;
  return "--yarn-radius cannot be " + knit::quoted(words.radius) + "; give a number of stitch widths from " +
         knit::number_text(least_yarn_radius) + " to " + knit::number_text(most_yarn_radius) + ", or auto.";
}

void apply_yarn_wish(Session& session, const YarnWish& wish) {
  if (wish.looking) apply(session, ShowAs{*wish.looking});
  if (wish.layers)
    for (std::size_t i = 0; i < layer_count; ++i)
      apply(session, SetLayer{static_cast<Layer>(i), wish.layers->at(i)});
  YarnLook look = session.view->yarn;
  look.wool = wish.wool.value_or(look.wool);
  look.second = wish.second.value_or(look.second);
  look.stripe_rounds = wish.stripe_rounds.value_or(look.stripe_rounds);
  look.by = wish.by.value_or(look.by);
  look.radius = wish.radius.value_or(look.radius);
  look.easing = wish.easing.value_or(look.easing);
  if (look != session.view->yarn) apply(session, SetYarnLook{look});
}

}  // namespace app
