// SPDX-License-Identifier: MIT
// The one file that knows yaml-cpp. Its exceptions end here.
#include "base/yaml_events.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <sstream>
#include <utility>

namespace stig {

namespace {

/// Thrown through the parser to end it: who takes the events wants no more.
struct Stop {};

class Translator : public YAML::EventHandler {
 public:
  explicit Translator(const std::function<bool(const YamlEvent&)>& take) : take_(take) {}

  void OnDocumentStart(const YAML::Mark& mark) override { say(Kind::document, mark); }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { say(Kind::null, mark); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { say(Kind::alias, mark); }
  void OnAnchor(const YAML::Mark& mark, const std::string& name) override {
    say(Kind::anchor, mark, name);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& value) override {
    say(Kind::scalar, mark, value, tag);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value style) override {
    say(Kind::sequence, mark, {}, tag, style == YAML::EmitterStyle::Flow);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  YAML::EmitterStyle::value style) override {
    say(Kind::mapping, mark, {}, tag, style == YAML::EmitterStyle::Flow);
  }
  void OnSequenceEnd() override { say(Kind::sequence_end, YAML::Mark()); }
  void OnMapEnd() override { say(Kind::mapping_end, YAML::Mark()); }

 private:
  using Kind = YamlEvent::Kind;

  void say(Kind kind, const YAML::Mark& mark, const std::string& text = {},
           const std::string& tag = {}, bool flow = false) {
    const std::size_t at = mark.pos < 0 ? 0 : static_cast<std::size_t>(mark.pos);
    if (!take_({kind, at, text, tag, flow})) throw Stop();
  }

  const std::function<bool(const YamlEvent&)>& take_;
};

}  // namespace

std::optional<YamlFault> parse_events(const std::string& text,
                                      const std::function<bool(const YamlEvent&)>& take) {
  Translator translator(take);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(translator)) {
    }
  } catch (const Stop&) {
    return std::nullopt;
  } catch (const YAML::Exception& error) {
    YamlFault fault{std::nullopt, error.msg};
    if (error.mark.pos >= 0) fault.at = static_cast<std::size_t>(error.mark.pos);
    return fault;
  }
  return std::nullopt;
}

}  // namespace stig
