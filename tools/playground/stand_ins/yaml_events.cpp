// SPDX-License-Identifier: MIT
// Events from the page's own parser (tools/viewer/src/playground/yaml_events.ts), in place of
// lib/base/yaml_events.cpp. It hands all of them over at once, as JSON: a list of
// [kind, place, text, tag, flow], which may end earlier, and a fault.
#include "base/yaml_events.h"

#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

/// Of the page. Both texts end with a null byte; the result is freed here.
extern "C" __attribute__((import_module("page"), import_name("yaml_events"))) char*
stig_yaml_events(const char* text);

namespace stig {

namespace {

using Json = nlohmann::json;

YamlEvent event_of(const Json& list) {
  YamlEvent out;
  out.kind = static_cast<YamlEvent::Kind>(list[0].get<int>());
  out.at = list[1].get<std::size_t>();
  if (list.size() > 2) out.text = list[2].get<std::string>();
  if (list.size() > 3) out.tag = list[3].get<std::string>();
  if (list.size() > 4) out.flow = list[4].get<bool>();
  return out;
}

}  // namespace

std::optional<YamlFault> parse_events(const std::string& text,
                                      const std::function<bool(const YamlEvent&)>& take) {
  const std::unique_ptr<char, void (*)(void*)> said(stig_yaml_events(text.c_str()), std::free);
  const Json json = Json::parse(said.get(), nullptr, false);
  for (const Json& event : json["events"]) {
    if (!take(event_of(event))) return std::nullopt;
  }
  const Json& fault = json["fault"];
  if (fault.is_null()) return std::nullopt;
  return YamlFault{fault["at"].get<std::size_t>(), fault["reason"].get<std::string>()};
}

}  // namespace stig
