// SPDX-License-Identifier: MIT
#include "robots/form_keys.h"
#include "robots/robot_forms.h"

namespace stig {

namespace {

using namespace keys;

FormKey device_name() { return required(words("name", FormKind::name, "What programs call it.")); }
FormKey on_body() { return required(words("body", FormKind::name, "The body it is fixed to.")); }
FormKey at() { return vector("at", "Where, metres, body's frame (default: its origin).", kFar); }

FormKey resolution() {
  FormKey key = numbers("resolution", "Pixels, width and height.", 2, 2, 1, 16384);
  key.kind = FormKind::integers;
  return key;
}

const Form& lift_speed_form() {
  static const Form kForm{
      "speed of the lift",
      {required(number("above", "Where the error is above this, metres,", 0, kFar)),
       required(above_zero("speed", "this is the speed, metres a second.", kFar))}};
  return kForm;
}

const Form& pole_form() {
  static const Form kForm{
      "pole",
      {on_body(), vector("at", "Of the dipole, metres, body's frame (default: the middle).", kFar),
       vector("direction", "Of its moment, body's frame (default: up).", kFar)}};
  return kForm;
}

}  // namespace

const Form& drive_form() {
  static const Form kForm{
      "differential drive",
      {required(words("left", FormKind::names, "Joints of the wheels on the left.")),
       required(words("right", FormKind::names, "Joints of the wheels on the right.")),
       required(above_zero("wheel_radius", "Metres.", kFar)),
       required(above_zero("track", "Metres between left and right.", kFar)),
       required(above_zero("most_speed", "Of the rims, metres a second.", 100)),
       above_zero("most_acceleration", "Of the rims, metres a second squared (default: 1).",
                  1000)}};
  return kForm;
}

const Form& lift_form() {
  static const Form kForm{
      "lift",
      {required(words("joint", FormKind::name, "With one axis that slides.")),
       required(numbers("switches",
                        "Positions at which the limit switches close, bottom and top, metres.", 2,
                        2, -kFar, kFar)),
       above_zero("inactive_below", "Error under which it reports rest, metres.", kFar),
       required(parts("speeds", "By falling error; under the last it rests.", lift_speed_form(), 1,
                      16))}};
  return kForm;
}

const Form& electromagnets_form() {
  static const Form kForm{
      "set of electromagnets",
      {required(parts("poles", "Its dipoles.", pole_form(), 1, 64)),
       number("passive", "Field without current, as of a block's magnets (default: 0).", 0, 1e6),
       required(number("active", "Field added for a current of 1.", 0, 1e6)),
       above_zero("charge_limit", "Where charging ends.", 1e6),
       number("charge_per_second", "Of even charging, while no current flows.", 0, 1e6),
       number("discharge_per_second", "Part of the charge that a current takes.", 0, 1e6),
       number("relax_rate", "Of charging towards the limit, a second.", 0, 1e6),
       number("sink_rate", "Of discharging towards sink_level, a second.", 0, 1e6),
       number("sink_level", "Charge that a current alone would end at.", 0, 1e6)}};
  return kForm;
}

const Form& camera_form() {
  static const Form kForm{
      "camera",
      {device_name(), on_body(), at(),
       required(vector("look", "The direction it looks in, body's frame.", kFar)),
       vector("up", "What is up in its image (default: z).", kFar), required(resolution()),
       required(numbers("focal_length", "Pixels, of x and y.", 2, 2, 1e-3, 1e6)),
       required(numbers("principal_point", "Pixels, from the upper left.", 2, 2, -1e6, 1e6)),
       numbers("distortion", "As OpenCV has it: k1 k2 p1 p2 [k3 [k4 k5 k6 [s1 s2 s3 s4]]].", 4, 12,
               -1e6, 1e6),
       required(above_zero("near", "Nothing nearer is seen, metres.", 1000)),
       required(above_zero("far", "Nothing farther is seen, metres.", 1000))}};
  return kForm;
}

const Form& rangefinder_form() {
  static const Form kForm{
      "rangefinder",
      {device_name(), on_body(), at(),
       required(vector("look", "The direction of its ray, body's frame.", kFar)),
       required(above_zero("range", "Metres.", 1000)),
       choice("calibration",
              "Of its reading: the metres themselves, or with v = exp(-metres) a v^b (power) or "
              "c0 + c1 v + c2 v² (quadratic).",
              {"metres", "power", "quadratic"}),
       numbers("coefficients", "[a, b] or [c0, c1, c2].", 2, 3, -1e9, 1e9)}};
  return kForm;
}

const Form& radio_form() {
  static const Form kForm{
      "radio", {device_name(), on_body(), at(), required(above_zero("range", "Metres.", 1000))}};
  return kForm;
}

const Form& led_form() {
  static const Form kForm{"LED", {device_name(), on_body(), at()}};
  return kForm;
}

const Form& actuator_form() {
  static const Form kForm{"actuator",
                          {device_name(), required(words("joint", FormKind::name, "With a motor.")),
                           whole("axis", "Which of its axes, counted from 1 (default: 1).", 1, 6)}};
  return kForm;
}

}  // namespace stig
