// Entries about parameters: each can be set by its name, each choice is an entry, and changes from here on.
#include "app/core/action_entries_parts.h"
#include "app/core/parameters_text.h"
#include "app/core/presets.h"
#include "app/core/words.h"
#include "knit/gauge.h"

namespace app {

namespace {

using Read = std::variant<Action, std::string>;

constexpr const char* parameters = "Parameters";

std::optional<std::string> fault_in(const Session& session, const knit::Parameters& changed) {
  const knit::Input& input = session.timeline->input();
  return knit::fault_of(knit::agreed(changed, input), input.mesh);
}

Read tuned(const Session& session, const knit::ParameterInfo& info, const std::string& typed) {
  knit::Parameters changed = session.timeline->parameters();
  if (const auto error = knit::set_value(info, changed, typed)) return without_dashes(*error);
  knit::give_size_by(info.key, changed);
  if (const auto fault = fault_in(session, changed)) return without_dashes(*fault);
  return Tune{changed};
}

Read edited(const Session& session, const std::string& typed) {
  auto read = read_parameters_text(typed, session.timeline->parameters());
  if (const auto* error = std::get_if<std::string>(&read)) return *error;
  const auto& changed = std::get<knit::Parameters>(read);
  if (const auto fault = fault_in(session, changed)) return without_dashes(*fault);
  return EditFromHere{changed};
}

// "Set epsilon to..."; a direction's label is a sentence's beginning already.
std::string asking_for(const knit::ParameterInfo& info) {
  std::string name(info.label);
  if (std::holds_alternative<knit::DirectionChoice>(info.kind)) return name + "...";
  if (name[0] >= 'A' && name[0] <= 'Z') name[0] = static_cast<char>(name[0] - 'A' + 'a');
  return "Set " + name + " to...";
}

// Why it is of no use to set it now.
std::string why_not(const EntryList& list, const knit::ParameterInfo& info) {
  if (!list.session.timeline) return list.unless_open();
  return knit::is_read(info, list.session.timeline->parameters())
             ? ""
             : "With the parameters as they are nothing reads it.";
}

void add_choices(EntryList& list, const knit::ParameterInfo& info, const knit::Choice& choice) {
  const Session& session = list.session;
  for (std::size_t i = 0; i < choice.names.size(); ++i) {
    knit::Parameters changed = session.timeline ? session.timeline->parameters() : session.defaults;
    const bool now = session.timeline && choice.get(changed) == static_cast<int>(i);
    choice.set(changed, static_cast<int>(i));
    const std::string unused = why_not(list, info);
    list.add({std::string(info.label) + ": " + std::string(choice.names[i]), parameters,
              std::string(info.help), Tune{changed}, unused.empty() && now ? "It is so already." : unused, "",
              true});
  }
}

void add_parameter(EntryList& list, const knit::ParameterInfo& info) {
  if (const auto* choice = std::get_if<knit::Choice>(&info.kind)) return add_choices(list, info, *choice);
  const Session& session = list.session;
  const std::string now =
      knit::value_text(info, session.timeline ? session.timeline->parameters() : session.defaults);
  list.add({asking_for(info), parameters, std::string(info.help),
            ActionPrompt{std::string(info.label), now,
                         [&info](const Session& asked, const std::string& typed) {
                           return tuned(asked, info, typed);
                         }},
            why_not(list, info)});
}

// Picking in the view, instead of typing a number.
void add_picking(EntryList& list) {
  const bool picking = list.session.picking != Picking::nothing;
  list.add({"Pick the start vertex in the view", parameters, "Then click it; the time is 0 there.",
            SetPicking{Picking::start}, list.unless_open()});
  list.add({"Pick the end vertex in the view", parameters, "Then click it; the time is 1 there.",
            SetPicking{Picking::end}, list.unless_open()});
  list.add({"Pick nothing", parameters, "", SetPicking{Picking::nothing},
            picking ? "" : "Nothing is being picked."});
  list.add({"Pick vertex number...", parameters, "Instead of a click in the view.",
            ActionPrompt{"Vertex", "12",
                         [](const Session& session, const std::string& typed) -> Read {
                           const std::size_t count = session.timeline->input().mesh.positions.size();
                           const auto vertex = whole_number<knit::VertexId>(typed);
                           if (vertex && *vertex < count) return PickVertex{*vertex};
                           return "A vertex is a whole number from 0 to " + std::to_string(count - 1) +
                                  ", not \"" + typed + "\".";
                         }},
            picking ? list.unless_open() : "Nothing is being picked."});
}

void add_edits(EntryList& list) {
  const std::size_t edits = list.session.timeline ? list.session.timeline->edits().size() : 0;
  list.add({"Change a parameter from here on...", parameters,
            "What is past stays as it is; the rest is run anew.",
            ActionPrompt{"From here on", "epsilon = 0.05", edited}, list.unless_open()});
  list.add({"Take back the last change on the way", parameters, "", RemoveEdit{edits > 0 ? edits - 1 : 0},
            edits > 0 ? "" : "There is no change on the way."});
}

}  // namespace

void add_parameter_entries(EntryList& list) {
  for (const Preset& preset : presets()) {
    list.add({"Take the preset: " + std::string(preset.title), parameters, std::string(preset.about),
              ApplyPreset{std::string(preset.key)}, list.unless_open()});
  }
  for (const knit::ParameterInfo& info : knit::parameter_table()) add_parameter(list, info);
  add_picking(list);
  add_edits(list);
}

}  // namespace app
