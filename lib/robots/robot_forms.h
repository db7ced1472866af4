// SPDX-License-Identifier: MIT
// The keys of robot files; docs/robots.md explains them one by one.
#pragma once

#include "base/form.h"

namespace stig {

/// The whole file.
const Form& robot_form();
/// Devices, from robot_device_forms.cpp.
const Form& drive_form();
const Form& lift_form();
const Form& electromagnets_form();
const Form& camera_form();
const Form& rangefinder_form();
const Form& radio_form();
const Form& led_form();
const Form& actuator_form();

}  // namespace stig
