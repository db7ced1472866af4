// SPDX-License-Identifier: MIT
// What is said of files that make no robot, or not the one that they mean.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "support/golden.h"
#include "support/uses.h"
#include "urdf/import_robot.h"

namespace stig {
namespace {

std::string said(const std::string& name, const std::string& text, bool taken) {
  Diagnostics diagnostics;
  const auto out =
      urdf::import_description(std::make_shared<SourceFile>(name, text), "x", diagnostics);
  CHECK_MESSAGE(out.has_value() == taken, text);
  CHECK(diagnostics.has_errors() != taken);
  CHECK(!diagnostics.all().empty());
  return to_text(diagnostics);
}

const std::string kInertia = "<inertia ixx=\"4e-3\" iyy=\"4e-3\" izz=\"4e-3\"/>";
const std::string kMass = "<inertial><mass value=\"1\"/>" + kInertia + "</inertial>";
const std::string kBall =
    kMass + "<collision><geometry><sphere radius=\"0.1\"/></geometry></collision>";

std::string urdf_link(const std::string& name, const std::string& inside = kBall) {
  return "<link name=\"" + name + "\">" + inside + "</link>\n";
}
std::string urdf_joint(const std::string& name, const std::string& parent, const std::string& child,
                       const std::string& type = "fixed", const std::string& inside = "") {
  return fmt::format(
      "<joint name=\"{}\" type=\"{}\"><parent link=\"{}\"/><child link=\"{}\"/>{}</joint>\n", name,
      type, parent, child, inside);
}
std::string robot_of(const std::string& inside) {
  return "<robot name=\"r\">\n" + inside + "</robot>\n";
}
std::string both(const std::string& type, const std::string& inside = "") {
  return robot_of(urdf_link("a") + urdf_link("b") + urdf_joint("j", "a", "b", type, inside));
}

TEST_CASE("what is wrong with a description in URDF is said at its place") {
  const std::vector<std::string> refused = {
      "<robot name=\"r\"><link name=\"a\"></robot>",
      "<!DOCTYPE robot [<!ENTITY a \"b\">]><robot name=\"&a;\"/>",
      "<robot/><robot/>",
      "<urdf/>",
      robot_of(""),
      robot_of(urdf_link("a") + urdf_link("a")),
      robot_of(urdf_link("a") + urdf_link("b")),
      robot_of(urdf_link("a") + urdf_joint("j", "a", "c")),
      robot_of(urdf_link("a") + urdf_link("b") + urdf_joint("j", "a", "b") +
               urdf_joint("k", "a", "b")),
      robot_of(urdf_link("a") + urdf_link("b") + urdf_link("c") + urdf_joint("j", "b", "c") +
               urdf_joint("k", "c", "b")),
      robot_of(urdf_link("a") + urdf_link("b") + urdf_joint("j", "a", "b") +
               urdf_joint("j", "b", "a")),
      robot_of(
          urdf_link("a", "<collision><geometry><sphere radius=\"1\"/></geometry></collision>")),
      robot_of(urdf_link("a", "<inertial><mass value=\"nan\"/>" + kInertia + "</inertial>")),
      robot_of(urdf_link("a", "<inertial><mass value=\"1e300\"/>" + kInertia + "</inertial>")),
      robot_of(urdf_link("a", "<inertial><mass value=\"0\"/>" + kInertia + "</inertial>")),
      robot_of(urdf_link("a",
                         "<inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"3\"/>"
                         "</inertial>")),
      robot_of(urdf_link("a", "<inertial><mass value=\"1\"/></inertial>")),
      robot_of(urdf_link(
          "a", kMass + "<collision><geometry><box size=\"1 2\"/></geometry></collision>")),
      robot_of(urdf_link(
          "a", kMass + "<collision><geometry><box size=\"1 2 0\"/></geometry></collision>")),
      robot_of(urdf_link("a", kMass + "<collision><geometry><mesh filename=\"a.stl\"/></geometry>"
                                      "</collision>")),
      both("ball"),
      both("floating"),
      both("revolute"),
      both("prismatic", "<axis xyz=\"0 0 0\"/><limit lower=\"0\" upper=\"1\"/>"),
      both("revolute", "<limit lower=\"0.5\" upper=\"1\"/>"),
      both("continuous", "<mimic joint=\"k\"/>"),
      robot_of(urdf_link("world", "") + urdf_link("b") + urdf_joint("j", "world", "b")),
      robot_of(urdf_link("a") + urdf_link("m", "") + urdf_link("c") +
               urdf_joint("j", "a", "m", "continuous") + urdf_joint("k", "m", "c", "continuous")),
      robot_of(urdf_link("a") + "<xacro:wheel side=\"left\"/>\n"),
      robot_of(urdf_link("a") + "<gazebo reference=\"b\"/>\n"),
  };
  std::string all;
  for (const std::string& text : refused) all += said("r.urdf", text, false) + "\n";
  check_golden("tests/golden/urdf-refused.txt", all);
}

TEST_CASE("what URDF has and robots have not is left out, and said") {
  const std::vector<std::string> taken = {
      robot_of(urdf_link("a", kMass +
                                  "<visual><geometry><mesh filename=\"a.dae\"/></geometry></visual>"
                                  "<collision><geometry><sphere radius=\"0.1\"/></geometry>"
                                  "</collision>")),
      robot_of(urdf_link("a", kMass)),
      robot_of(
          urdf_link("a", "<inertial><origin xyz=\"0 0 1\"/><mass value=\"1\"/>" + kInertia +
                             "</inertial><collision><geometry><sphere radius=\"0.1\"/></geometry>"
                             "</collision>")),
      both("continuous", "<safety_controller k_velocity=\"1\"/><dynamics friction=\"0.1\"/>"),
      robot_of(urdf_link("a") + urdf_link("b", "") + urdf_joint("j", "a", "b", "continuous")),
      robot_of(urdf_link("a") + "<gazebo><plugin name=\"p\" filename=\"libp.so\"/></gazebo>\n"),
      robot_of(urdf_link("a") +
               "<gazebo reference=\"a\"><sensor type=\"imu\" name=\"s\"/><mu1>0.7</mu1>"
               "<kp>1</kp></gazebo>\n"),
      robot_of(urdf_link("a") +
               "<gazebo reference=\"a\"><sensor type=\"ray\" name=\"s\"><ray><scan>"
               "<horizontal><samples>90</samples></horizontal></scan><range><max>4</max>"
               "</range></ray></sensor></gazebo>\n"),
      robot_of(urdf_link("a") + urdf_link("b") + urdf_joint("j", "a", "b", "continuous") +
               "<transmission><joint name=\"j\"><hardwareInterface>VelocityJointInterface"
               "</hardwareInterface></joint><actuator name=\"m\"><mechanicalReduction>30"
               "</mechanicalReduction></actuator></transmission>\n"),
  };
  std::string all;
  for (const std::string& text : taken) all += said("r.urdf", text, true) + "\n";
  check_golden("tests/golden/urdf-left-out.txt", all);
}

std::string sdf_of(const std::string& inside) {
  return "<sdf version=\"1.9\">\n" + inside + "\n</sdf>\n";
}
std::string sdf_mass() {
  return "<inertial><mass>1</mass><inertia><ixx>4e-3</ixx><iyy>4e-3</iyy><izz>4e-3</izz></inertia>"
         "</inertial>";
}
std::string sdf_link(const std::string& name, const std::string& inside) {
  return "<link name=\"" + name + "\">" + sdf_mass() + inside +
         "<collision "
         "name=\"c\"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>"
         "</link>\n";
}
std::string model_of(const std::string& inside) {
  return sdf_of("<model name=\"m\">" + inside + "</model>");
}
std::string sdf_joint(const std::string& type, const std::string& inside,
                      const std::string& child = "b") {
  return model_of(sdf_link("a", "") + sdf_link("b", "") + "<joint name=\"j\" type=\"" + type +
                  "\"><parent>a</parent><child>" + child + "</child>" + inside + "</joint>\n");
}
std::string world_of(const std::string& inside) {
  return sdf_of("<world name=\"w\">" + inside + "</world>");
}

TEST_CASE("what is wrong with a description in SDF is said at its place") {
  const std::vector<std::string> refused = {
      sdf_of(""),
      model_of("<link name=\"a\"/>\n"),
      model_of(sdf_link("a", "<pose relative_to=\"b\">0 0 0 0 0 0</pose>")),
      model_of(sdf_link("a", "<pose relative_to=\"b\"/>") +
               sdf_link("b", "<pose relative_to=\"a\"/>")),
      model_of(sdf_link("a", "<pose>0 0 nan 0 0 0</pose>")),
      model_of(sdf_link("a", "<pose>0 0 0</pose>")),
      model_of(sdf_link("a", "") + sdf_link("a", "")),
      model_of(sdf_link("a", "<gravity>false</gravity>")),
      model_of("<static>true</static>" + sdf_link("a", "")),
      model_of("<include><uri>model://arm</uri></include>" + sdf_link("a", "")),
      sdf_joint("ball", ""),
      sdf_joint("revolute", ""),
      sdf_joint("fixed", "", "c"),
      sdf_joint("fixed", "", "world"),
      sdf_joint("revolute", "<axis><xyz>0 0 1</xyz><limit><lower>-1</lower></limit></axis>"),
      sdf_joint("revolute",
                "<axis><xyz>0 0 1</xyz><dynamics><spring_stiffness>2</spring_stiffness>"
                "</dynamics></axis>"),
      world_of("<include><uri>model://house</uri></include>"),
      world_of("<gravity>0 1 -9.8</gravity>"),
      world_of("<model name=\"m\"><static>true</static>" + sdf_link("a", "") + "</model>"),
      world_of("<model name=\"m\"><pose>0 0 1 0.5 0 0</pose>" + sdf_link("a", "") + "</model>"),
      world_of("<model name=\"m\"><pose relative_to=\"n\">0 0 1 0 0 0</pose>" + sdf_link("a", "") +
               "</model>"),
      world_of(
          "<model name=\"m\"><link name=\"a\">" + sdf_mass() +
          "<collision name=\"c\"><geometry><box><size>1 1 1</size></box></geometry></collision>"
          "</link></model>"),
  };
  std::string all;
  for (const std::string& text : refused) all += said("m.sdf", text, false) + "\n";
  check_golden("tests/golden/sdf-refused.txt", all);
}

TEST_CASE("what SDF has and scenes have not is left out, and said") {
  const std::vector<std::string> taken = {
      model_of("<self_collide>true</self_collide>" +
               sdf_link("a", "<velocity_decay/><sensor name=\"s\" type=\"gps\"/>")),
      world_of("<physics><max_step_size>0.1</max_step_size></physics><wind/>"),
      world_of("<model name=\"m\"><pose>0 0 1 0 0 0</pose>" + sdf_link("a", "") + "</model>"),
  };
  std::string all;
  for (const std::string& text : taken) all += said("m.sdf", text, true) + "\n";
  check_golden("tests/golden/sdf-left-out.txt", all);
}

TEST_CASE("files that are too large, too deep or no text are refused") {
  std::string deep, many = "<robot name=\"r\">";
  for (int i = 0; i < 5000; ++i) deep += "<a>";
  CHECK(said("r.urdf", deep, false).find("F430") != std::string::npos);
  for (int i = 0; i < 5000; ++i) deep += "</a>";
  CHECK(said("r.urdf", deep, false).find("deeper than 32") != std::string::npos);
  for (int i = 0; i < 501; ++i) many += urdf_link("l" + std::to_string(i));
  CHECK(said("r.urdf", many + "</robot>", false).find("more than 500 links") != std::string::npos);
  std::string elements = "<robot name=\"r\">";
  for (int i = 0; i < 100'001; ++i) elements += "<a/>";
  CHECK(said("r.urdf", elements + "</robot>", false).find("more than 100000") != std::string::npos);
  CHECK(said("r.urdf", std::string("<robot\0/>", 9), false).find("not text") != std::string::npos);
  CHECK(said("r.urdf", "<robot name=\"\xff\"/>", false).find("not text") != std::string::npos);
}

}  // namespace
}  // namespace stig
