// SPDX-License-Identifier: MIT
#include "validate/argos_experiment.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "support.h"
#include "support/golden.h"

namespace stig {
namespace {

struct Element {
  std::string name, text;
  double x = 0, y = 0, z = 0;
};

/// The arena's entities of one kind, by the form in which they are written.
std::vector<Element> entities(const std::string& xml, const std::string& kind) {
  std::vector<Element> out;
  const std::string begin = "<" + kind + " id=\"", end = "</" + kind + ">";
  for (std::size_t at = xml.find(begin); at != std::string::npos; at = xml.find(begin, at + 1)) {
    Element one;
    one.text = xml.substr(at, xml.find(end, at) - at);
    one.name = one.text.substr(begin.size(), one.text.find('"', begin.size()) - begin.size());
    const std::size_t body = one.text.find("position=\"");
    REQUIRE(std::sscanf(one.text.c_str() + body, "position=\"%lf,%lf,%lf", &one.x, &one.y,
                        &one.z) == 3);
    out.push_back(one);
  }
  return out;
}

double apart(const Element& a, const Element& b) { return std::hypot(a.x - b.x, a.y - b.y); }

TEST_CASE("experiments of the staircase and of the pyramid for four robots") {
  const CompiledSet staircase("staircase"), pyramid("stepped-pyramid");
  check_golden("tests/validate/golden/staircase.argos",
               argos_experiment(staircase.rules, staircase.compiled, {},
                                {"staircase_robot.lua", "staircase_block.lua"}));
  SetUpRequest four;
  four.robots = 4;
  check_golden("tests/validate/golden/pyramid.argos",
               argos_experiment(pyramid.rules, pyramid.compiled, four,
                                {"pyramid_robot.lua", "pyramid_block.lua"}));
}

TEST_CASE(
    "robots and the start stand where validate has them, with enough blocks far enough apart") {
  for (const char* name : {"staircase", "stepped-pyramid"}) {
    CAPTURE(name);
    const CompiledSet set(name);
    SetUpRequest request;
    request.robots = 6;
    const std::string xml = argos_experiment(set.rules, set.compiled, request, {"r", "b"});
    const SetUpLayout layout = lay_out(set.rules, set.compiled, request);
    const std::vector<Element> robots = entities(xml, "builderbot");
    const std::vector<Element> blocks = entities(xml, "block");
    REQUIRE(robots.size() == layout.robots.size());
    for (std::size_t i = 0; i < robots.size(); ++i) {
      CHECK(robots[i].x == doctest::Approx(layout.robots[i].at.x));
      CHECK(robots[i].y == doctest::Approx(layout.robots[i].at.y));
    }
    const std::size_t start = layout.blocks.size();
    REQUIRE(blocks.size() > start);
    for (std::size_t i = 0; i < start; ++i) {
      CHECK(blocks[i].text.find("movable=\"false\"") != std::string::npos);
      CHECK(blocks[i].x == doctest::Approx(layout.blocks[i].centre.x));
      CHECK(blocks[i].z == doctest::Approx(layout.blocks[i].centre.z - 0.0275));
    }
    CHECK(blocks.size() >= set.compiled.target->bricks() + set.compiled.sides.size());
    for (std::size_t i = start; i < blocks.size(); ++i) {
      CHECK(blocks[i].text.find("movable") == std::string::npos);
      for (std::size_t k = 0; k < i; ++k) CHECK(apart(blocks[i], blocks[k]) > 0.19);
      // The end effector reaches 0.131 m ahead.
      for (const Element& robot : robots) CHECK(apart(blocks[i], robot) > 0.2);
    }
  }
}

TEST_CASE("robots are bound to the sides that validate binds them to") {
  const CompiledSet set("stepped-pyramid");
  for (const int robots : {1, 2, 4, 6}) {
    CAPTURE(robots);
    SetUpRequest request;
    request.robots = robots;
    const std::string xml = argos_experiment(set.rules, set.compiled, request, {"r", "b"});
    const SetUpLayout layout = lay_out(set.rules, set.compiled, request);
    const std::vector<Element> elements = entities(xml, "builderbot");
    REQUIRE(elements.size() == layout.robots.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const std::string& text = elements[i].text;
      const std::size_t name = text.find("config=\"") + 8;
      const std::size_t at =
          xml.find("<lua_controller id=\"" + text.substr(name, text.find('"', name) - name) + "\"");
      REQUIRE(at != std::string::npos);
      std::string wanted = "side=\"" + std::string(to_string(layout.robots[i].side)) + '"';
      for (const ApproachSide side : layout.robots[i].bound) {
        wanted += (side == layout.robots[i].bound.front() ? " sides=\"" : " ") +
                  std::string(to_string(side));
      }
      if (!layout.robots[i].bound.empty()) wanted += '"';
      if (i >= 4) wanted += " standby=\"1\"";
      if (robots > 1) wanted += " crew=\"" + std::to_string(robots) + '"';
      wanted += "/>";
      const std::size_t params = xml.find("<params", at), end = xml.find("/>", params) + 2;
      CHECK(xml.substr(params, end - params) == "<params script=\"r\" " + wanted);
    }
  }
}

TEST_CASE("crews of different sizes have controllers of their own") {
  const CompiledSet set("stepped-pyramid");
  SetUpRequest request;
  request.robots = 5;
  request.structures = 2;
  const std::string xml = argos_experiment(set.rules, set.compiled, request, {"r", "b"});
  for (const char* crew : {"3", "2"}) {
    const std::string id = std::string("id=\"builder+x-of") + crew + '"';
    const std::size_t at = xml.find("<lua_controller " + id);
    REQUIRE(at != std::string::npos);
    const std::size_t params = xml.find("<params", at), end = xml.find("/>", params);
    CHECK(xml.substr(params, end - params).find(std::string("crew=\"") + crew + '"') !=
          std::string::npos);
    CHECK(xml.find("config=\"builder+x-of" + std::string(crew) + '"') != std::string::npos);
  }
}

TEST_CASE("names of scripts stay in their attributes") {
  const CompiledSet set("staircase");
  const std::string xml =
      argos_experiment(set.rules, set.compiled, {}, {"a\"/><b x=\"&.lua", "<c>.lua"});
  CHECK(xml.find("script=\"a&quot;/&gt;&lt;b x=&quot;&amp;.lua\"") != std::string::npos);
  CHECK(xml.find("script=\"&lt;c&gt;.lua\"") != std::string::npos);
}

}  // namespace
}  // namespace stig
