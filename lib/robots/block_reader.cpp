// SPDX-License-Identifier: MIT
// The form below is the only place that lists a block's keys: it checks files, words the messages
// and makes the JSON Schema. What relates keys to each other, which a schema cannot say, comes
// after it in check_fit. Angles are degrees in files and radians in the model.
#include <cassert>

#include "base/degree.h"
#include "base/form.h"
#include "base/load.h"
#include "base/yaml.h"
#include "robots/block.h"
#include "robots/form_keys.h"
#include "robots/robot_forms.h"

namespace stig::robots {

namespace {

using namespace keys;

// Block files have some dozens of lines; one that is larger is something else, and is not read.
constexpr std::size_t kMaxBlockFileBytes = std::size_t{1} << 16;

/// A number that must be there.
FormKey needed(std::string_view name, std::string_view doc, double low, double high) {
  return required(number(name, doc, low, high));
}

const Form& body_keys() {
  static const Form kKeys{"block's body",
                          {needed("side", "Of the cube, m.", 1e-3, 10),
                           needed("mass", "kg, without magnets.", 1e-6, 1e5),
                           needed("friction", "Coulomb's coefficient.", 0, 10)}};
  return kKeys;
}

const Form& magnet_keys() {
  static const Form kKeys{
      "block's magnets",
      // The bounds of numbers only keep out what cannot be meant, and values at which the solver's
      // arithmetic would lose its meaning; they are wider than any real block.
      {needed("offset", "m: centres at (±offset, ±offset, ±offset).", 1e-6, 10),
       needed("radius", "m, of the spheres.", 1e-6, 10), needed("mass", "kg, of each.", 0, 1e5),
       needed("field", "In the paper's unit: 75 is 0.199 A·m².", 0, 1e6),
       needed("cutoff", "m, beyond which magnets ignore each other.", 1e-6, 10)}};
  return kKeys;
}

const Form& tag_keys() {
  static const Form kKeys{
      "block's tags",
      {needed("side", "m, of the square within the white border.", 1e-4, 10),
       needed("widest", "Degrees off the normal at which it is read still.", 0, 89.9),
       number("proud", "m that it stands out.", 0, 0.1)}};
  return kKeys;
}

const Form& led_keys() {
  static const Form kKeys{
      "block's LEDs",
      {needed("offset", "m from the face's middle, four ways.", 1e-4, 10),
       needed("widest", "Degrees off the normal at which they are seen still.", 0, 180)}};
  return kKeys;
}

const Form& radio_keys() {
  static const Form kKeys{
      "block's radios",
      {number("depth", "m below the face's middle.", 0, 1), needed("range", "m.", 1e-4, 10),
       words("answers", FormKind::boolean, "Whether its program answers what it is told.")}};
  return kKeys;
}

}  // namespace

const Form& block_form() {
  static const Form kForm{
      "block file",
      {version("stigc_block", "Version of the format: 1.", 1),
       required(words("name", FormKind::name, "A short name.")),
       words("title", FormKind::text, "One line for people."),
       words("source", FormKind::text, "Where the figures are from."),
       required(part("body", "A cube of one mass.", body_keys())),
       part("magnets", "Eight spheres in the corners, free to turn.", magnet_keys()),
       part("tags", "One on each face.", tag_keys()),
       // Face marks and radios are options: physics alone needs none of them.
       part("leds", "Four on each face, directional.", led_keys()),
       part("radios", "One behind each face, near field, half duplex.", radio_keys()),
       words("program", FormKind::name, "Lua file that it runs in scenes with robots.")}};
  return kForm;
}

namespace {

BlockModel read_model(const FormView& root) {
  BlockModel out;
  out.name = root.text("name");
  out.title = root.text("title");
  out.source = root.text("source");
  out.program = root.text("program");
  // A part that is missing reads as zeros, which is how the model says "none".
  const FormView body = root.form("body"), magnets = root.form("magnets");
  out.side = body.number("side");
  out.body_mass = body.number("mass");
  out.friction = body.number("friction");
  out.magnet_offset = magnets.number("offset");
  out.magnet_radius = magnets.number("radius");
  out.magnet_mass = magnets.number("mass");
  out.magnet_field = magnets.number("field");
  out.magnet_cutoff = magnets.number("cutoff");
  const FormView tags = root.form("tags"), leds = root.form("leds"), radios = root.form("radios");
  out.tags = {tags.number("side"), tags.number("proud"), tags.number("widest") * kDegree};
  out.leds = {leds.number("offset"), leds.number("widest") * kDegree};
  out.radios = {radios.number("depth"), radios.number("range"), radios.flag("answers")};
  return out;
}

/// Everything lies within its face or body; the block's own magnets ignore each other.
void check_fit(const YamlDocument& document, const BlockModel& block, Diagnostics& out) {
  const auto complain = [&](std::string_view part, std::string_view key, std::string message) {
    // Only called for a part whose value is out of place, hence one that the file has.
    const YamlNode& node = *document.root.find(part)->find(key);
    out.add(Code::R105, document.head(node), std::move(message));
  };
  const double half = block.side / 2;
  // Magnets turn freely in their places, so the whole ball has to lie inside.
  if (block.has_magnets() && block.magnet_offset + block.magnet_radius > half) {
    complain("magnets", "offset",
             "the magnets stick out of the block: offset and radius together are at most half "
             "its side");
  } else if (block.has_magnets() && block.magnet_cutoff > 2 * block.magnet_offset) {
    // The nearest two of a block are 2 · offset apart. Were they to interact, their forces would
    // cancel within the body and cost time only.
    complain("magnets", "cutoff",
             "a block's own magnets would feel each other: the cut-off is at most twice the "
             "offset");
  }
  if (block.tags.side > block.side) {
    complain("tags", "side", "the tag is larger than the face");
  }
  if (block.leds.offset > half) complain("leds", "offset", "the LEDs are beyond the face");
  if (block.radios.depth > half) complain("radios", "depth", "the radios are beyond the middle");
}

}  // namespace

std::optional<BlockModel> read_block(SourceRef source, Diagnostics& diagnostics) {
  assert(source != nullptr);
  Diagnostics own;
  std::optional<BlockModel> block;
  if (const auto document = parse_yaml(std::move(source), {kMaxBlockFileBytes, 8, 1000}, own)) {
    const BadNodes bad = check_form(*document, block_form(), own);
    // Fit is judged on sound values only; a second message about a bad one would not help.
    if (!own.has_errors()) block = read_model(FormView(document->root, bad));
    if (block) check_fit(*document, *block, own);
  }
  diagnostics.append(own);
  return own.has_errors() ? std::nullopt : block;
}

std::optional<BlockModel> read_block_file(const std::string& path, Diagnostics& diagnostics) {
  SourceRef source = load_source(path, kMaxBlockFileBytes, diagnostics);
  return source ? read_block(std::move(source), diagnostics) : std::nullopt;
}

std::string block_schema() {
  return form_schema(block_form(), "stigc block, version 1",
                     "A block: mass, magnets, tags, LEDs, radios. Metres, kilograms, degrees.");
}

}  // namespace stig::robots
