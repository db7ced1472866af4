// SPDX-License-Identifier: MIT
// Work that takes long, with the interpreter's lock released and Ctrl-C looked for meanwhile.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>

#include "app.h"

namespace stig::python {

/// Calls what takes long in a thread of its own, while this one looks for signals.
template <class Work>
auto interruptible(Work work) {
  auto result = std::async(std::launch::async, std::move(work));
  bool interrupted = false;
  while (true) {
    std::future_status status;
    {
      const pybind11::gil_scoped_release others;
      status = result.wait_for(std::chrono::milliseconds(interrupted ? 1000 : 100));
    }
    if (status == std::future_status::ready) break;
    if (!interrupted && PyErr_CheckSignals() != 0) {
      interrupted = true;
      cli::request_stop(true);
    }
  }
  cli::request_stop(false);
  if (interrupted) throw pybind11::error_already_set();
  return result.get();
}

}  // namespace stig::python
